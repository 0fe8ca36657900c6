# Libraries and how they are installed: as a package that find_package(PeridynamicDegradation) finds, whose targets are
# called PeridynamicDegradation::materials and so on, where they are pd_materials here.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(PD_HEADER_DIR ${CMAKE_INSTALL_INCLUDEDIR}/peridynamic_degradation)
# Where programs look for pd_multigrid: in the build, and beside bin/.
set(PD_LIBRARY_DIR ${PROJECT_BINARY_DIR}/driver)
set(CMAKE_BUILD_RPATH ${PD_LIBRARY_DIR})
set(CMAKE_INSTALL_RPATH $ORIGIN/../${CMAKE_INSTALL_LIBDIR})
set(PD_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/PeridynamicDegradation)

# pd_export(target ...)
function(pd_export)
  foreach(target ${ARGV})
    string(REGEX REPLACE "^pd_" "" exported ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${exported})
  endforeach()
  install(TARGETS ${ARGV} EXPORT PeridynamicDegradationTargets)
endfunction()

# What nearly every source reads and no change touches, read once a library: more than half of the compiler's time.
set(PD_PRECOMPILED_HEADERS
    <algorithm> <array> <cmath> <fstream> <functional> <limits> <map> <memory> <numeric> <optional> <set> <sstream>
    <stdexcept> <string> <utility> <vector> <Teuchos_Array.hpp> <Teuchos_ParameterList.hpp> <Teuchos_RCP.hpp>)

# Sources of a library go to the compiler eight at a time, which takes a third of its time and finds names that two of
# them use for different things.
set(PD_SOURCES_AT_A_TIME 8 CACHE STRING "Sources of a library that are compiled as one; 1: each by itself")

# pd_add_library(name SOURCES a.cpp ... [FOLDERS of headers that are included by their names ...])
# A library of which a program gets everything. Plug-ins register themselves and are named by nobody: of a plain archive,
# name_archive, the linker would leave them out.
function(pd_add_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;FOLDERS" ${ARGN})
  add_library(${name}_archive STATIC ${arg_SOURCES})
  set_target_properties(${name}_archive PROPERTIES OUTPUT_NAME ${name} UNITY_BUILD ON
                                                   UNITY_BUILD_BATCH_SIZE ${PD_SOURCES_AT_A_TIME})
  target_link_libraries(${name}_archive PUBLIC pd_options)
  target_precompile_headers(${name}_archive PRIVATE ${PD_PRECOMPILED_HEADERS})
  foreach(folder ${PROJECT_SOURCE_DIR} ${arg_FOLDERS})
    file(RELATIVE_PATH installed ${PROJECT_SOURCE_DIR} ${folder})
    target_include_directories(${name}_archive PUBLIC $<BUILD_INTERFACE:${folder}>
                                                      $<INSTALL_INTERFACE:${PD_HEADER_DIR}/${installed}>)
  endforeach()
  add_library(${name} INTERFACE)
  target_link_libraries(${name} INTERFACE $<LINK_LIBRARY:WHOLE_ARCHIVE,$<TARGET_NAME:${name}_archive>>)
  # Elsewhere, too, these folders come before the system's: Trilinos has an Epetra_Comm.h of its own.
  set_target_properties(${name}_archive PROPERTIES EXPORT_NO_SYSTEM ON)
  pd_export(${name}_archive ${name})
endfunction()

install(DIRECTORY materials compute driver DESTINATION ${PD_HEADER_DIR} FILES_MATCHING PATTERN *.hpp PATTERN *.h
        PATTERN driver/package EXCLUDE)
install(EXPORT PeridynamicDegradationTargets NAMESPACE PeridynamicDegradation:: DESTINATION ${PD_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/PeridynamicDegradationConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES driver/package/PeridynamicDegradationConfig.cmake driver/package/dependencies.cmake
              ${PROJECT_BINARY_DIR}/PeridynamicDegradationConfigVersion.cmake DESTINATION ${PD_PACKAGE_DIR})
install(FILES LICENSE CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
