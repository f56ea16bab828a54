# What keeps building short. Most of a file's compilation is headers, and most of the rest is optimizing what takes no
# time when it runs.

find_program(CCACHE ccache)
if(CCACHE AND PROJECT_IS_TOP_LEVEL)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_CURRENT_LIST_DIR}/cached_compiler)
endif()

# A few files at a time take half as long as one by one. -DRAYSCOPE_BATCH=1 for who edits and compiles.
set(RAYSCOPE_BATCH 8 CACHE STRING "How many source files are compiled at a time")
if(PROJECT_IS_TOP_LEVEL AND RAYSCOPE_BATCH GREATER 1 AND NOT DEFINED CMAKE_UNITY_BUILD)
  set(CMAKE_UNITY_BUILD ON)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE ${RAYSCOPE_BATCH})
endif()

# GCC looks through its memory for what it can free whenever it took a third more, headers compiled before included: a
# twentieth of the time, for a tenth of the memory.
if(PROJECT_IS_TOP_LEVEL)
  add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU>:--param=ggc-min-heapsize=4000000>)
endif()

# rayscope_no_hot_loop(target): little optimization, since all that takes time happens in core. But whatever uses the
# wide registers must also clear them (vzeroupper, which GCC's -O1 leaves out), or __float128 takes eight times as long:
# a template of core's may be taken from here. All that share headers need the same options: headers compiled before
# bring theirs along.
function(rayscope_no_hot_loop target)
  target_compile_options(
    ${target} PRIVATE $<$<CONFIG:Release>:-O1> $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-fexpensive-optimizations>)
endfunction()

# rayscope_shared_headers(name [HOT] LIBRARIES … HEADERS …): headers compiled once, for all targets that say
# rayscope_use_headers(target name). Rays wait for those of a HOT one; the others get little optimization.
# -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON shows what a file forgot to include.
function(rayscope_shared_headers name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "HOT" "" "LIBRARIES;HEADERS")
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp CONTENT "")
  add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  set_target_properties(${name} PROPERTIES RAYSCOPE_HOT ${arg_HOT})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES})
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
  rayscope_warnings(${name})
  if(NOT arg_HOT)
    rayscope_no_hot_loop(${name})
  endif()
endfunction()

function(rayscope_use_headers target name)
  get_target_property(libraries ${name} LINK_LIBRARIES)
  get_target_property(is_hot ${name} RAYSCOPE_HOT)
  target_link_libraries(${target} PRIVATE ${libraries})
  target_precompile_headers(${target} REUSE_FROM ${name})
  if(NOT is_hot)
    rayscope_no_hot_loop(${target})
  endif()
endfunction()
