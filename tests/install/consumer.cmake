# Installs the library under a folder of its own, builds the example there as a stranger's project would, runs it, and looks
# at what it links.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "status ${status} from: ${ARGV}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${folder})
run(${CMAKE_COMMAND} --install ${build} --prefix ${folder}/prefix)

# The README shows the very files that are built here; see readme.sh.
file(COPY ${source}/tests/install/example DESTINATION ${folder})
run(${CMAKE_COMMAND} -S ${folder}/example -B ${folder}/build -G ${generator} -D CMAKE_PREFIX_PATH=${folder}/prefix
  -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_CXX_FLAGS=${flags})
file(STRINGS ${folder}/build/CMakeCache.txt found REGEX "^contensou_DIR:")
if(NOT found MATCHES "=${folder}/prefix/")
  message(FATAL_ERROR "found another installation: ${found}")
endif()
run(${CMAKE_COMMAND} --build ${folder}/build)

# Hertz pressure, u = 2, by hand: xi = 9 sqrt(3)/16, eta = (3/64)(4pi - 6 sqrt(3)), times mu lambda_N = 3 N.
run(${folder}/build/example)
set(expected "lambda_T1 = -2.92284 N, tau_N = -0.305728 N times R\n")
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "the example printed\n${output}expected\n${expected}")
endif()

# Normal impulse m (1 + 1/2); the others from the law: u = 0.2760 of the slip after the impact, xi = 0.3190, eta = 0.5455,
# times mu Lambda_N = 0.051 N s.
run(${folder}/build/contact)
set(expected "normal 0.255, friction -0.0162684, torque / R -0.027818 N s, solved\n")
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "the contact problem printed\n${output}expected\n${expected}")
endif()

# Neither the example nor the installed program links GSL, and what is exported names no library but Eigen.
foreach(program IN ITEMS ${folder}/build/example ${folder}/prefix/bin/contensou)
  run(ldd ${program})
  if(output MATCHES "gsl")
    message(FATAL_ERROR "${program} links GSL:\n${output}")
  endif()
endforeach()
file(GLOB_RECURSE exported ${folder}/prefix/*.cmake)
if(NOT exported)
  message(FATAL_ERROR "nothing was exported")
endif()
foreach(file IN LISTS exported)
  file(READ ${file} text)
  string(REGEX MATCHALL "[A-Za-z0-9_]+::[A-Za-z0-9_]+" targets "${text}")
  list(FILTER targets EXCLUDE REGEX "contensou::(contensou|scene)$|^Eigen3::Eigen$")
  if(targets OR text MATCHES "gsl|GSL|[Bb]oost")
    message(FATAL_ERROR "${file} asks for more than Eigen: ${targets}")
  endif()
endforeach()
message("installed, found, built, ran")
