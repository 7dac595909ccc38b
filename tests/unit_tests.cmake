# Half of the time of building the unit tests one by one goes into the same
# templates, instantiated in each of them, and into reading deal.II's libraries to
# link each. So they are compiled several at a time, each in a namespace of its
# own, into one library; what deal.II builds of x.cc, tests.x.debug, is a main()
# that calls x_test::main() there, and is linked to that library alone.

# generate(FILE TEXT): leaves a file of the same text as old as it is.
function(generate _file _text)
  file(WRITE ${_file}.in "${_text}")
  configure_file(${_file}.in ${_file} COPYONLY)
endfunction()

# compile_together(TYPE NAME...): the tests NAME.cc, in batches
function(compile_together _type)
  set(_directory ${CMAKE_CURRENT_BINARY_DIR}/unit_tests)
  set(_names ${ARGN})
  set(_batches "")
  while(_names)
    list(SUBLIST _names 0 8 _batch)
    list(REMOVE_ITEM _names ${_batch})
    list(GET _batch 0 _first)

    # Headers come first: within the namespaces they are found read.
    set(_includes "")
    set(_text "")
    foreach(_name ${_batch})
      set(_source ${CMAKE_CURRENT_SOURCE_DIR}/${_name}.cc)
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${_source})
      file(STRINGS ${_source} _lines REGEX "^#include")
      list(APPEND _includes ${_lines})
      string(APPEND _text
             "namespace ${_name}_test\n{\n#include \"${_source}\"\n}\n")

      generate(${_directory}/${_name}_main.cc
               "namespace ${_name}_test\n{\n  int main();\n}\n\n\
int main()\n{\n  return ${_name}_test::main();\n}\n")
      set(_target tests.${_name}.${_type})
      get_target_property(_sources ${_target} SOURCES)
      list(REMOVE_ITEM _sources ${_source})
      set_target_properties(${_target} PROPERTIES
        SOURCES "${_sources};${_directory}/${_name}_main.cc"
        LINK_LIBRARIES $<TARGET_FILE:unit_test_sources> UNITY_BUILD OFF)
      add_dependencies(${_target} unit_test_sources)
    endforeach()
    list(REMOVE_DUPLICATES _includes)
    list(JOIN _includes "\n" _includes)
    generate(${_directory}/${_first}_and_more.cc "${_includes}\n\n${_text}")
    list(APPEND _batches ${_directory}/${_first}_and_more.cc)
  endwhile()

  add_library(unit_test_sources SHARED EXCLUDE_FROM_ALL ${_batches})
  target_compile_definitions(unit_test_sources
                             PRIVATE SOURCE_DIR="${CMAKE_CURRENT_SOURCE_DIR}")
  # main() of a namespace has to return, unlike the one that a program begins in.
  target_compile_options(unit_test_sources PRIVATE -Werror=return-type)
  set_target_properties(unit_test_sources PROPERTIES UNITY_BUILD OFF)
  target_link_libraries(unit_test_sources closed_forms)
  target_precompile_headers(unit_test_sources REUSE_FROM contact_core)
  deal_ii_setup_target(unit_test_sources)
endfunction()
