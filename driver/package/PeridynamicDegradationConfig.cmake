# find_package(PeridynamicDegradation): targets for programs with plug-ins of their own (README.md, "Plug-ins of your own").
include(${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/PeridynamicDegradationTargets.cmake)
