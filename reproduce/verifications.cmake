# The programs whose numbers the report is made of. A verification that fails must not keep the page from being made:
# each is run by run_and_record.cmake, which notes the exit status in parts/status-NAME.tsv and always succeeds; the
# verdict (the last step of `reproduce`, `verify`, `report`) then fails.
#
# They run one at a time on the terminal: their progress is seen, and the benchmark does not compete with them.
file(GLOB_RECURSE reference_tables CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/reference_data/*.tsv)

# contensou_run(PROGRAM "comment" TABLES names... [DRAWN_BY SCRIPT.gp DRAWINGS names...] [OPTIONAL reason])
# makes the target run_PROGRAM; the
# status file's name goes into ${PROGRAM}_status, the command into ${PROGRAM}_command. Where the program ended well,
# SCRIPT.gp draws its tables in the style of the figures. A table or drawing that is missing is made again. A program that was
# not built is a failure, unless it is OPTIONAL: then it is noted as skipped, for that reason.
function(contensou_run program comment)
  cmake_parse_arguments(arg "" "DRAWN_BY;OPTIONAL" "TABLES;DRAWINGS" ${ARGN})
  list(TRANSFORM arg_TABLES REPLACE "(.+)" "${report_data}/\\1.tsv" OUTPUT_VARIABLE tables)
  list(TRANSFORM arg_DRAWINGS REPLACE "(.+)" "${report_figures}/\\1.svg" OUTPUT_VARIABLE drawings)
  set(status ${report_data}/parts/status-${program}.tsv)
  set(run ${CMAKE_COMMAND} -Dname=${program} -Dfolder=${report_data} -Dstatus=${status})
  set(script ${CMAKE_CURRENT_SOURCE_DIR}/run_and_record.cmake)
  if(TARGET ${program})
    if(arg_DRAWN_BY)
      list(APPEND run -Dgnuplot=${GNUPLOT} -Ddrawing=${arg_DRAWN_BY} -Dfigures=${report_figures}
                      -Dstyle=${CMAKE_CURRENT_SOURCE_DIR}/style.gp)
    endif()
    list(APPEND run -Dprogram=$<TARGET_FILE:${program}>)
    add_custom_command(OUTPUT ${status} ${tables} ${drawings}
      COMMAND ${run} -P ${script}
      DEPENDS ${program} ${script} ${reference_tables} ${arg_DRAWN_BY}
      COMMENT "${comment}" USES_TERMINAL VERBATIM)
  else()
    list(APPEND run -Dprogram= "-Dskipped=${arg_OPTIONAL}")
    add_custom_command(OUTPUT ${status}
      COMMAND ${run} -P ${script}
      DEPENDS ${script}
      COMMENT "${program} was not built: noted as not run" VERBATIM)
  endif()
  add_custom_target(run_${program} DEPENDS ${status})
  set(${program}_status ${status} PARENT_SCOPE)
  set(${program}_command ${run} -Dstrict=ON -P ${script} PARENT_SCOPE)
endfunction()

contensou_run(verify_quadrature "Verification: the definition (2.1) by adaptive quadrature"
  TABLES verify_quadrature verify_quadrature_radial verify_quadrature_vectors parts/claims-quadrature)
contensou_run(verify_ledger "Verification: every equation and claim of the paper"
  TABLES parts/claims-ledger parts/ledger-ledger)
contensou_run(verify_plates "Verification: the friction plates"
  TABLES plates parts/claims-plates)
contensou_run(verify_ball "Verification: projection on the friction ball"
  TABLES ball ball_iterations parts/claims-ball)
contensou_run(verify_accuracy "Verification: accuracy in ulp"
  TABLES accuracy accuracy_loss accuracy_over_u accuracy_power parts/claims-accuracy
  DRAWN_BY ${PROJECT_SOURCE_DIR}/verify/accuracy/accuracy.gp DRAWINGS accuracy)
contensou_run(verify_augmented "Verification: the paper's iteration over r"
  TABLES augmented_r augmented_radius parts/claims-augmented
  DRAWN_BY ${PROJECT_SOURCE_DIR}/verify/augmented/augmented_r.gp DRAWINGS augmented_r)
contensou_run(verify_contact "Verification: how reliable the contact solvers are, on 100 000 random problems"
  TABLES robustness robustness_by_class robustness_profile parts/claims-contact
  DRAWN_BY ${PROJECT_SOURCE_DIR}/verify/contact/robustness.gp DRAWINGS robustness)
contensou_run(verify_consistency "Verification: energy, power and order of contacts on random problems"
  TABLES consistency parts/claims-consistency)
contensou_run(verify_stability "Verification: stability of the spinning top"
  TABLES stability_growth fig11_simulated parts/claims-stability
  DRAWN_BY ${PROJECT_SOURCE_DIR}/verify/stability/stability_growth.gp DRAWINGS stability_growth)
contensou_run(verify_integrators "Verification: orders and habits of the integrators"
  TABLES integrator_orders integrator_errors integrator_habits integrator_nutation integrator_paper_top
         parts/claims-integrators parts/ledger-integrators
  DRAWN_BY ${PROJECT_SOURCE_DIR}/verify/integrators/integrators.gp DRAWINGS integrator_orders integrator_nutation)
contensou_run(verify_story "Verification: the story of the tippe-top"
  TABLES event_story story_hypotheses story_theta inversion_over_radius coulomb_limit end_states parts/claims-story
         parts/ledger-story
  DRAWN_BY ${PROJECT_SOURCE_DIR}/verify/story/story.gp DRAWINGS story inversion_over_radius)
contensou_run(verify_scenes "Verification: the scenes that ship against their answers"
  TABLES scenes scenes_limits scenes_disc scenes_disc_ends parts/claims-scenes
  DRAWN_BY ${PROJECT_SOURCE_DIR}/verify/scenes/scenes.gp DRAWINGS scenes_disc)
contensou_run(verify_siconos "Verification: against Siconos, points of contact and patches cut into points"
  OPTIONAL "Siconos is not installed"
  TABLES siconos_coulomb siconos_patch siconos_ball parts/claims-siconos
  DRAWN_BY ${PROJECT_SOURCE_DIR}/verify/siconos/siconos_patch.gp DRAWINGS siconos_patch)
contensou_run(verify_absent "Verification: what is absent costs nothing, by counting"
  OPTIONAL "valgrind is not installed"
  TABLES cost_absent parts/claims-absent)
contensou_run(bench_effects "What each effect costs, in instructions"
  OPTIONAL "valgrind is not installed"
  TABLES effect_costs)
contensou_run(bench_laws "What accuracy costs: measuring"
  TABLES cost_laws cost_laws_front cost_ratios
  DRAWN_BY ${PROJECT_SOURCE_DIR}/bench/laws/cost_laws.gp DRAWINGS cost_laws)

contensou_run(bench_projection "What the projection on the friction ball costs: measuring"
  TABLES cost_projection cost_projection_front cost_projection_aims
  DRAWN_BY ${PROJECT_SOURCE_DIR}/bench/projection/cost_projection.gp DRAWINGS cost_projection)

contensou_run(bench_solvers "What the contact problem costs: measuring"
  TABLES cost_solvers cost_solvers_front cost_solver_ratios
  DRAWN_BY ${PROJECT_SOURCE_DIR}/bench/solvers/cost_solvers.gp DRAWINGS cost_solvers)

contensou_run(bench_integrators "What the motion of the tippe-top costs: measuring"
  TABLES cost_integrators cost_integrators_front cost_integrators_failures cost_integrators_aims
  DRAWN_BY ${PROJECT_SOURCE_DIR}/bench/integrators/cost_integrators.gp DRAWINGS cost_integrators)

contensou_run(bench_bodies "What many bodies cost: measuring"
  TABLES cost_bodies
  DRAWN_BY ${PROJECT_SOURCE_DIR}/bench/bodies/cost_bodies.gp DRAWINGS cost_bodies)

# Measured times stand until the program changes; who asks for them by name wants them measured now.
set(bench_commands "")
set(bench_programs "")
foreach(program IN ITEMS bench_laws bench_projection bench_solvers bench_integrators bench_bodies)
  list(APPEND bench_commands COMMAND ${${program}_command})
  if(TARGET ${program})
    list(APPEND bench_programs ${program})
  endif()
endforeach()
add_custom_target(bench ${bench_commands} COMMENT "What accuracy costs: measuring" USES_TERMINAL VERBATIM)
if(bench_programs)
  add_dependencies(bench ${bench_programs})
endif()

set(verification_statuses
  ${verify_quadrature_status} ${verify_ledger_status} ${verify_plates_status} ${verify_ball_status} ${verify_accuracy_status}
  ${verify_augmented_status} ${verify_contact_status} ${verify_consistency_status} ${verify_stability_status}
  ${verify_integrators_status} ${verify_story_status} ${verify_scenes_status} ${verify_siconos_status} ${verify_absent_status})
