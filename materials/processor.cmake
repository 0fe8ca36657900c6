# What bond loops are compiled with, in either host: the options PD_MATH_OPTIONS, and PD_ARCH_OPTIONS, by which a vector
# of the processor holds PD_LANES doubles.
set(PD_ARCH native CACHE STRING "Processor to compile for, as in -march=: native, x86-64-v3 ...; empty: any of its family")
include(CheckCXXCompilerFlag)
include(CheckCXXSourceCompiles)

set(PD_MATH_OPTIONS -fno-math-errno -fno-trapping-math)
set(PD_ARCH_OPTIONS)
if(PD_ARCH)
  string(MAKE_C_IDENTIFIER "PD_HAS_ARCH_${PD_ARCH}" has_arch)
  check_cxx_compiler_flag(-march=${PD_ARCH} ${has_arch})
  if(NOT ${has_arch})
    message(FATAL_ERROR "PD_ARCH: this compiler has no -march=${PD_ARCH}; its manual names the processors that it knows")
  endif()
  list(APPEND PD_ARCH_OPTIONS -march=${PD_ARCH})
endif()
check_cxx_compiler_flag(-mprefer-vector-width=512 PD_HAS_VECTOR_WIDTH)
if(PD_HAS_VECTOR_WIDTH)
  list(APPEND PD_ARCH_OPTIONS -mprefer-vector-width=512)
endif()

string(MAKE_C_IDENTIFIER "PD_LANES_${PD_ARCH}" lanes_of_arch)
if(NOT DEFINED ${lanes_of_arch})
  list(JOIN PD_ARCH_OPTIONS " " CMAKE_REQUIRED_FLAGS)
  string(APPEND CMAKE_REQUIRED_FLAGS " -std=c++17")
  foreach(lanes 2 4 8)
    check_cxx_source_compiles(
      "#include <experimental/simd>
       static_assert(std::experimental::native_simd<double>::size() == ${lanes}, \"\");
       int main() {}" ${lanes_of_arch}_IS_${lanes})
    if(${lanes_of_arch}_IS_${lanes})
      set(${lanes_of_arch} ${lanes} CACHE INTERNAL "Doubles in a vector")
    endif()
  endforeach()
  unset(CMAKE_REQUIRED_FLAGS)
endif()
if(NOT DEFINED ${lanes_of_arch})
  message(FATAL_ERROR "this compiler has no <experimental/simd> of C++17 with vectors of 2, 4 or 8 doubles: GCC 11 or later "
                      "has, and Clang 14 with GCC's standard library")
endif()
set(PD_LANES ${${lanes_of_arch}})
