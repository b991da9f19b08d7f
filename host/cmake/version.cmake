# SPDX-License-Identifier: Apache-2.0
# Script: writes OUTPUT, the header with the VERSION and the commit of the checkout ROOT.
cmake_minimum_required(VERSION 3.25)
set(commit unknown)
if(EXISTS ${ROOT}/.git)
  execute_process(COMMAND git -C ${ROOT} describe --always --dirty --abbrev=12 --exclude=*
                  OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(described)
    set(commit ${described})
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT
"// Written by host/cmake/version.cmake.
#pragma once
#define GONIO_PROGRAM \"gonio ${VERSION} (${commit})\"
")
