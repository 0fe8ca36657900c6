# What links the libraries of this project needs these, here and in a project that finds it installed.
find_package(MPI REQUIRED COMPONENTS CXX)
find_package(Trilinos REQUIRED COMPONENTS Teuchos Tpetra Belos Ifpack2 MueLu Amesos2 Zoltan2)
find_package(yaml-cpp REQUIRED)
find_package(tinyxml2 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(muparser REQUIRED)
# MUMPS, by its own interface, in double and single precision: Debian's Amesos2 hides it.
find_library(MUMPS_LIBRARY dmumps REQUIRED)
find_library(SINGLE_MUMPS_LIBRARY smumps REQUIRED)
