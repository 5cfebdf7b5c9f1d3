# cmake -Dname=... -Dprogram=PATH -Dfolder=DATA -Dstatus=FILE [-Dskipped=REASON]
#       [-Dgnuplot=PATH -Ddrawing=SCRIPT -Dstyle=FILE -Dfigures=FOLDER] [-Dstrict=ON] -P run_and_record.cmake
# Runs `program --out folder`, then the drawing; a program that is empty was not built, which is a failure unless it may be
# skipped for a reason. Writes exit status and duration as a table; succeeds whatever they say,
# unless it is to be strict.
string(TIMESTAMP begin "%s" UTC)
if(program)
  execute_process(COMMAND ${program} --out ${folder} RESULT_VARIABLE result)
elseif(skipped)
  set(result "skipped: ${skipped}")
else()
  set(result "not built")
endif()
if(drawing AND result STREQUAL "0")
  file(MAKE_DIRECTORY ${figures})
  execute_process(COMMAND ${gnuplot} -e "style='${style}'; data='${folder}'; figures='${figures}'" ${drawing}
                  RESULT_VARIABLE result)
endif()
string(TIMESTAMP end "%s" UTC)
math(EXPR seconds "${end} - ${begin}")
if(NOT result STREQUAL "0")
  message("${name}: ${result}; noted for the verdict")
endif()
file(WRITE ${status} "# how a program of this report ended; units: seconds\nprogram\tstatus\tseconds\n${name}\t${result}\t${seconds}\n")
if(strict AND NOT result STREQUAL "0")
  message(FATAL_ERROR "${name}: ${result}")
endif()
