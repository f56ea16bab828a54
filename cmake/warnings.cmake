# rayscope_warnings(target): the warnings that the project is free of.
function(rayscope_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wshadow -Wdouble-promotion
                                           $<$<BOOL:${RAYSCOPE_WERROR}>:-Werror>)
endfunction()
