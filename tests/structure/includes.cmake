# Reads every #include of the library and fails where one climbs.
#
# Calls run one way: scene -> granular -> system -> integrate -> contact -> ball -> law, and out to output. A file may include its
# own layer and those below it; output stands apart: it may be included by scene, system and integrate, which report,
# but not by contact, ball and law, which only compute, and it includes only text, the one folder that everything may use. Outside its own headers the
# library knows the standard library, Eigen and Boost. GSL, being GPL, is for the programs around it.
#
# Usage: cmake -DLIBRARY=.../lib/contensou -P includes.cmake

cmake_minimum_required(VERSION 3.25)

set(text_may text)
set(law_may law text)
set(ball_may ball ${law_may})
set(contact_may contact ${ball_may})
set(integrate_may integrate output ${contact_may})
set(system_may system ${integrate_may})
set(granular_may granular ${system_may})
set(scene_may scene ${granular_may})
set(output_may output text)

# Headers of the standard library carry neither dot nor slash; these are the others that a file may include.
set(foreign_allowed "^(Eigen|boost)/|^immintrin\\.h$")
# The scene reader's parser, in one file and in no header, so that an installed library does not need it.
set(toml_file scene/document.cpp)

file(GLOB_RECURSE files RELATIVE ${LIBRARY} ${LIBRARY}/*.hpp ${LIBRARY}/*.cpp)
if(NOT files)
  message(FATAL_ERROR "${LIBRARY}: no sources found")
endif()

set(count 0)
set(offences "")
foreach(file IN LISTS files)
  string(REGEX MATCH "^[^/]+" layer ${file})
  if(NOT DEFINED ${layer}_may)
    list(APPEND offences "${file}: folder '${layer}' has no place in the order of includes.cmake")
    continue()
  endif()
  file(STRINGS ${LIBRARY}/${file} lines REGEX "^[ \t]*#[ \t]*include")
  foreach(line IN LISTS lines)
    math(EXPR count "${count} + 1")
    string(REGEX REPLACE "^[ \t]*#[ \t]*include[ \t]*[<\"]([^>\"]*)[>\"].*$" "\\1" header "${line}")
    if(header MATCHES "^contensou/([^/]+)/")
      if(NOT CMAKE_MATCH_1 IN_LIST ${layer}_may)
        list(APPEND offences "${file} includes ${header}: '${layer}' may know only: ${${layer}_may}")
      endif()
    elseif(header MATCHES "^toml" AND file STREQUAL toml_file)
      # allowed
    elseif(header MATCHES "^gsl/")
      list(APPEND offences "${file} includes ${header}: the library must not need GSL")
    elseif(header MATCHES "[./]" AND NOT header MATCHES "${foreign_allowed}")
      list(APPEND offences "${file} includes ${header}: expected contensou/..., Eigen, Boost or the standard library")
    endif()
  endforeach()
endforeach()

if(offences)
  list(JOIN offences "\n  " text)
  message(FATAL_ERROR "includes that climb or do not belong:\n  ${text}")
endif()
message(STATUS "${count} includes, all descend")
