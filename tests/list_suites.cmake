# SPDX-License-Identifier: Apache-2.0
# Script: writes OUTPUT, which tells ctest the suites of the GoogleTest binary TESTS. Suites whose
# name has `Long` in it get the label `long`.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${TESTS} --gtest_list_tests OUTPUT_VARIABLE listing
                COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n[^ \n#]+\\." suites "\n${listing}")
set(text "")
foreach(suite IN LISTS suites)
  string(STRIP "${suite}" suite)
  string(REGEX REPLACE "\\.$" "" name "${suite}")
  string(APPEND text "add_test([==[${name}]==] [==[${TESTS}]==] [==[--gtest_filter=${suite}*]==]"
                     " --gtest_brief=1)\n")
  # Over all models: the longest begin first, so that no processor waits for them at the end.
  if(name MATCHES "^Registry/")
    string(APPEND text "set_tests_properties([==[${name}]==] PROPERTIES COST 100)\n")
  endif()
  if(name MATCHES "Long")
    string(APPEND text "set_tests_properties([==[${name}]==] PROPERTIES LABELS long)\n")
  endif()
endforeach()
file(WRITE ${OUTPUT} "${text}")
