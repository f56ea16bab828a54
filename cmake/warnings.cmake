# rayscope_warnings(target): the warnings that the project is free of.
function(rayscope_warnings target)
  target_compile_options(
    ${target}
    PRIVATE -Wall -Wextra -Wconversion -Wshadow -Wdouble-promotion
            # GCC 12 sees overlaps in "literal" + std::string where there are none (GCC bug 105651).
            $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<BOOL:${RAYSCOPE_WERROR}>:-Werror>)
endfunction()
