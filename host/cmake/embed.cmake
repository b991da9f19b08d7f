# SPDX-License-Identifier: Apache-2.0
# Script: writes OUTPUT, a C++ source whose FUNCTION gives the files listed in FILES as strings.
cmake_minimum_required(VERSION 3.25)
file(STRINGS ${FILES} files)
set(entries "")
list(LENGTH files count)
foreach(file IN LISTS files)
  string(REGEX REPLACE "^(${ROOT}/(kernels|include|host)|/.*/chart.js)/" "" path "${file}")
  file(READ ${file} text)
  string(APPEND entries "    EmbeddedFile{\"${path}\",\n R\"embedded(${text})embedded\"},\n")
endforeach()
file(WRITE ${OUTPUT}
"// Written by host/cmake/embed.cmake.
#include \"opencl/embedded.hpp\"

#include <array>

namespace gonio {
std::span<const EmbeddedFile> ${FUNCTION}()
{
    static constexpr std::array<EmbeddedFile, ${count}> files = {{\n${entries}}};
    return files;
}
}  // namespace gonio
")
