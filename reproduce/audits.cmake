# What each effect of some scenes that ship is worth: contensou effects --audit, its table and its picture.
set(audit_files "")
foreach(scene IN ITEMS tippe_top sliding_disc polishing_machine)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/audit/${scene})
  set(table ${report_data}/audit_${scene}.tsv)
  set(drawing ${report_figures}/audit_${scene}.svg)
  add_custom_command(OUTPUT ${table} ${drawing}
    COMMAND contensou_program effects scenes/${scene}.toml --audit --quiet --out ${folder}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${report_figures} ${report_data}
    COMMAND ${CMAKE_COMMAND} -E copy ${folder}/audit.tsv ${table}
    COMMAND ${CMAKE_COMMAND} -E copy ${folder}/audit.svg ${drawing}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    DEPENDS contensou_program ${PROJECT_SOURCE_DIR}/scenes/${scene}.toml
    COMMENT "What each effect is worth: ${scene}" VERBATIM)
  list(APPEND audit_files ${table} ${drawing})
endforeach()
add_custom_target(audits DEPENDS ${audit_files})
