# SPDX-License-Identifier: Apache-2.0
# The sources that the build writes: kernels and data as strings, and the version with its commit.
set(generated_dir ${CMAKE_BINARY_DIR}/generated)
set(generated_sources)

# Writes `function`() of opencl/embedded.hpp, which gives the files named behind it. Each file's
# name is told relative to whichever of kernels/, include/ and host/ it lies in, if it does.
function(gonio_embed function)
  set(output ${generated_dir}/${function}.cpp)
  string(REPLACE ";" "\n" files "${ARGN}")
  file(CONFIGURE OUTPUT ${output}.files CONTENT "${files}" @ONLY)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -D FUNCTION=${function} -D FILES=${output}.files -D OUTPUT=${output}
            -D ROOT=${CMAKE_SOURCE_DIR} -P ${CMAKE_SOURCE_DIR}/host/cmake/embed.cmake
    DEPENDS ${ARGN} ${output}.files ${CMAKE_SOURCE_DIR}/host/cmake/embed.cmake
    COMMENT "Embedding ${function}" VERBATIM)
  set(generated_sources ${generated_sources} ${output} PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE kernel_files CONFIGURE_DEPENDS kernels/*.cl kernels/*.h include/gonio/shared/*)
gonio_embed(kernel_files ${kernel_files})
file(GLOB_RECURSE data_files CONFIGURE_DEPENDS host/data/*.csv host/data/*.toml)
gonio_embed(data_files ${data_files})
# Reports hold the library that draws their charts, so that they need no network.
find_file(CHART_JS chart.min.js PATHS /usr/share/javascript/chart.js REQUIRED)
gonio_embed(page_files ${CMAKE_SOURCE_DIR}/host/timings/report.html ${CHART_JS})

# Looks for the commit in every build, and touches version.hpp only when it is another one.
add_custom_target(gonio_version
  COMMAND ${CMAKE_COMMAND} -D VERSION=${PROJECT_VERSION} -D ROOT=${CMAKE_SOURCE_DIR}
          -D OUTPUT=${generated_dir}/version.hpp -P ${CMAKE_SOURCE_DIR}/host/cmake/version.cmake
  BYPRODUCTS ${generated_dir}/version.hpp
  COMMENT "Looking up the commit" VERBATIM)
