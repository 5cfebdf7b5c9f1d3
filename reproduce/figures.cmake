find_program(GNUPLOT gnuplot)
if(NOT GNUPLOT)
  message(WARNING "gnuplot not found (Debian: gnuplot-nox): the figures cannot be drawn")
  set(GNUPLOT gnuplot)
endif()

add_library(reproduce_common STATIC common/curves.cpp common/outline.cpp common/tippe_top_motion.cpp)
target_link_libraries(reproduce_common PUBLIC contensou report_program PRIVATE contensou_options)

set(figure_files "")

# contensou_figure(NAME DATA names... DRAWINGS names... [ALSO names...]): NAME/NAME.cpp writes the tables DATA, NAME/NAME.gp
# draws them and the tables ALSO, which a program of verifications.cmake writes.
function(contensou_figure name)
  cmake_parse_arguments(arg "" "" "DATA;DRAWINGS;ALSO" ${ARGN})
  list(TRANSFORM arg_DATA PREPEND ${report_data}/ OUTPUT_VARIABLE tables)
  list(TRANSFORM tables APPEND .tsv)
  list(TRANSFORM arg_ALSO REPLACE "(.+)" "${report_data}/\\1.tsv" OUTPUT_VARIABLE also)
  list(TRANSFORM arg_DRAWINGS PREPEND ${report_figures}/ OUTPUT_VARIABLE drawings)
  list(TRANSFORM drawings APPEND .svg)

  add_executable(figure_${name} ${name}/${name}.cpp)
  target_link_libraries(figure_${name} PRIVATE reproduce_common contensou_options)
  add_custom_command(OUTPUT ${tables}
    COMMAND figure_${name} --out ${report_data}
    DEPENDS figure_${name}
    COMMENT "Figure ${name}: curves" VERBATIM)
  add_custom_command(OUTPUT ${drawings}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${report_figures}
    COMMAND ${GNUPLOT} -e "style='${CMAKE_CURRENT_SOURCE_DIR}/style.gp'; mesh='${CMAKE_CURRENT_SOURCE_DIR}/common/mesh.gp'; data='${report_data}'; figures='${report_figures}'"
            ${CMAKE_CURRENT_SOURCE_DIR}/${name}/${name}.gp
    DEPENDS ${tables} ${also} ${name}/${name}.gp style.gp common/mesh.gp
    COMMENT "Figure ${name}: drawing" VERBATIM)
  add_custom_target(${name} DEPENDS ${drawings})
  set(figure_files ${figure_files} ${tables} ${drawings} PARENT_SCOPE)
endfunction()

contensou_figure(fig01 DATA fig01 fig01_curves fig01_lines DRAWINGS fig01)
contensou_figure(fig02 DATA fig02a fig02b DRAWINGS fig02a fig02b)
contensou_figure(fig03 DATA fig03a fig03b fig03b_printed fig03c DRAWINGS fig03a fig03b fig03c)
contensou_figure(fig04 DATA fig04 fig04_printed DRAWINGS fig04)
contensou_figure(fig05 DATA fig05a fig05b DRAWINGS fig05a fig05b)
contensou_figure(fig06 DATA fig06a fig06a_set fig06b fig06b_set DRAWINGS fig06a fig06b)
contensou_figure(fig07 DATA fig07a fig07a_curves fig07a_lines fig07b fig07b_curves fig07b_lines DRAWINGS fig07a fig07b)
contensou_figure(fig08 DATA fig08 fig08_curves fig08_lines DRAWINGS fig08)
contensou_figure(fig09 DATA fig09 fig09_events fig09_nutation fig09_printed DRAWINGS fig09a fig09b)
contensou_figure(fig10 DATA fig10 fig10_rocking fig10_impacts DRAWINGS fig10a fig10b fig10c)
contensou_figure(fig11 DATA fig11 fig11_positions fig11_roots ALSO fig11_simulated DRAWINGS fig11)
contensou_figure(fig12 DATA fig12 fig12_events DRAWINGS fig12)
add_custom_target(figures DEPENDS fig01 fig02 fig03 fig04 fig05 fig06 fig07 fig08 fig09 fig10 fig11 fig12)

# The animation's data; the page draws it.
add_executable(make_animation animation/animation.cpp)
target_link_libraries(make_animation PRIVATE reproduce_common contensou_options)
add_custom_command(OUTPUT ${report_data}/animation.tsv
  COMMAND make_animation --out ${report_data}
  DEPENDS make_animation
  COMMENT "Animation: motion" VERBATIM)
add_custom_target(animation DEPENDS ${report_data}/animation.tsv)
list(APPEND figure_files ${report_data}/animation.tsv)

# A study by the program itself: does the top invert, and when, over contact radius and spin? Inversion times to 1e-5 s.
set(top_scene ${PROJECT_SOURCE_DIR}/scenes/tippe_top.toml)
add_custom_command(OUTPUT ${report_data}/phase_map.tsv
  COMMAND contensou_program sweep ${top_scene} --set integrator.tolerance=1e-8 --set output.interval=5e-3
    --set "outcome.inversion={kind=\"crossing\", column=\"theta\", value=1.5707963267948966}"
    --set "outcome.stick={kind=\"event\", event=\"close\", contact=\"tip\"}"
    --vary contact.body.radius=1e-6:3e-3:40:log --vary initial.psi_dot=40:250:43
    --restart --out ${report_data}/phase_map.tsv
  DEPENDS contensou_program ${top_scene}
  COMMENT "Phase map of inversion: 1720 runs" USES_TERMINAL VERBATIM)
add_executable(figure_phase_map phase_map/phase_map.cpp)
target_link_libraries(figure_phase_map PRIVATE reproduce_common contensou_options)
add_custom_command(OUTPUT ${report_data}/phase_map_spins.tsv
  COMMAND figure_phase_map --out ${report_data}
  DEPENDS figure_phase_map
  COMMENT "Phase map of inversion: least spins" VERBATIM)
add_custom_command(OUTPUT ${report_figures}/phase_map.svg
  COMMAND ${CMAKE_COMMAND} -E make_directory ${report_figures}
  COMMAND ${GNUPLOT} -e "style='${CMAKE_CURRENT_SOURCE_DIR}/style.gp'; data='${report_data}'; figures='${report_figures}'"
          ${CMAKE_CURRENT_SOURCE_DIR}/phase_map/phase_map.gp
  DEPENDS ${report_data}/phase_map.tsv ${report_data}/phase_map_spins.tsv phase_map/phase_map.gp style.gp
  COMMENT "Phase map of inversion: drawing" VERBATIM)
add_custom_target(phase_map DEPENDS ${report_figures}/phase_map.svg)
list(APPEND figure_files ${report_data}/phase_map.tsv ${report_data}/phase_map_spins.tsv ${report_figures}/phase_map.svg)
