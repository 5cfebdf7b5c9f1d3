# cmake -Dname=... -Dprogram=PATH -Dfolder=DATA -Dstatus=FILE -P run_and_record.cmake
# Runs `program --out folder`, writes exit status and duration as a table, succeeds whatever the program says.
string(TIMESTAMP begin "%s" UTC)
if(program)
  execute_process(COMMAND ${program} --out ${folder} RESULT_VARIABLE result)
else()
  set(result "not built")
endif()
string(TIMESTAMP end "%s" UTC)
math(EXPR seconds "${end} - ${begin}")
if(NOT result STREQUAL "0")
  message("${name}: ${result}; noted for the verdict")
endif()
file(WRITE ${status} "# how a program of this report ended; units: seconds\nprogram\tstatus\tseconds\n${name}\t${result}\t${seconds}\n")
