# The keys of the files that people write, as JSON Schemas for editors and as pages, from their declarations in
# app/file_keys. They are installed where the first line of each shipped file expects them; the target schemas_in_tree
# copies the schemas to the same place in the sources, where git ignores them.
include(GNUInstallDirs)
set(folder ${PROJECT_BINARY_DIR}/config)
file(MAKE_DIRECTORY ${folder})
foreach(kind items playlist rig scenario study)
  set(schema ${folder}/${kind}.schema.json)
  set(plural ${kind}s)
  string(REGEX REPLACE "ys$" "ies" plural ${plural})
  string(REGEX REPLACE "ss$" "s" plural ${plural})
  set(page ${folder}/keys-of-${plural}.md)
  add_custom_command(OUTPUT ${schema} ${page}
    COMMAND carom help --schema ${kind} > ${schema}
    COMMAND carom help --keys ${kind} > ${page}
    DEPENDS carom VERBATIM)
  list(APPEND schemas ${schema})
  list(APPEND pages ${page})
endforeach()
add_custom_target(schemas ALL DEPENDS ${schemas} ${pages})
add_custom_target(schemas_in_tree
  COMMAND ${CMAKE_COMMAND} -E copy_if_different ${schemas} ${PROJECT_SOURCE_DIR}/config
  DEPENDS ${schemas})
install(FILES ${schemas} COMPONENT program DESTINATION ${CMAKE_INSTALL_DATADIR}/carom)
install(FILES ${pages} COMPONENT program DESTINATION ${CMAKE_INSTALL_DOCDIR}/app/doc)
