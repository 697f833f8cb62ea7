# The fuzz targets of test/fuzz: fuzz_replay, which feeds files to all of them, and with COLLISION_HULLS_FUZZ (clang) a libFuzzer program
# for each.

file(GLOB FUZZ_TARGETS CONFIGURE_DEPENDS test/fuzz/*.cpp)
list(FILTER FUZZ_TARGETS EXCLUDE REGEX "/(target|in_process|fuzzer|replay)\\.cpp$")

# add_fuzz_program(NAME MAIN TARGET...)
function(add_fuzz_program name main)
  add_executable(${name} EXCLUDE_FROM_ALL ${main} test/fuzz/target.cpp test/fuzz/in_process.cpp ${ARGN})
  target_include_directories(${name} PRIVATE test src)
  target_link_libraries(${name} ${PROJECT_NAME}_decode ${PROJECT_NAME} found::tinyxml2)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/fuzz")
endfunction()

add_fuzz_program(fuzz_replay test/fuzz/replay.cpp ${FUZZ_TARGETS})
if(COLLISION_HULLS_FUZZ)
  add_custom_target(fuzzers)
  foreach(source ${FUZZ_TARGETS})
    get_filename_component(target ${source} NAME_WE)
    add_fuzz_program(fuzz_${target} test/fuzz/fuzzer.cpp ${source})
    target_link_options(fuzz_${target} PRIVATE -fsanitize=fuzzer)
    add_dependencies(fuzzers fuzz_${target})
  endforeach()
elseif(TARGET tests)
  add_dependencies(tests fuzz_replay)
endif()
