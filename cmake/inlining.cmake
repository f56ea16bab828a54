# rayscope_inline_all(source...): files in which the stages and kernels that every ray goes through meet. One with all of
# them inlined is beyond what GCC takes for sane: it would call functions of one line. Headers compiled before would bring
# other options along.
function(rayscope_inline_all)
  set_source_files_properties(
    ${ARGN}
    PROPERTIES
      SKIP_PRECOMPILE_HEADERS ON
      COMPILE_OPTIONS
      "$<$<CXX_COMPILER_ID:GNU>:--param=inline-unit-growth=400;--param=large-function-growth=400;--param=large-unit-insns=100000>"
  )
endfunction()
