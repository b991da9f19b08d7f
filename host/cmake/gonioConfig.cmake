# SPDX-License-Identifier: Apache-2.0
# find_package(gonio CONFIG) gives gonio::gonio; these are the libraries that it needs.
include(CMakeFindDependencyMacro)
find_dependency(glm)
find_dependency(OpenCL)
find_dependency(OpenEXR 3.1)
find_dependency(PNG)
find_dependency(PkgConfig)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo)
find_dependency(fmt)
find_dependency(tomlplusplus)
find_dependency(Threads)
include(${CMAKE_CURRENT_LIST_DIR}/gonioTargets.cmake)
