#include "blas.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <string>

namespace pd {

namespace {

/// Null where the program's libraries have none of that name.
template <class Function>
Function* ofLibraries(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

/// As OPENBLAS_CORETYPE names it; null where OpenBLAS' own choice has to do.
const char* coreOfProcessor() {
#if defined(__x86_64__) && defined(__GNUC__)
  const bool has512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
  if (has512) return "SkylakeX";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return "Haswell";
#endif
  return nullptr;
}

}  // namespace

void prepareBlas() {
  constexpr const char* variable = "OPENBLAS_CORETYPE";
  auto* const chosen = ofLibraries<char*()>("openblas_get_corename");
  auto* const forget = ofLibraries<void()>("gotoblas_dynamic_quit");
  auto* const choose = ofLibraries<void()>("gotoblas_dynamic_init");
  const char* const core = coreOfProcessor();
  if (chosen == nullptr || forget == nullptr || choose == nullptr || core == nullptr) return;
  if (std::getenv(variable) != nullptr || std::string(chosen()) != "Prescott") return;
  setenv(variable, core, 1);
  forget();
  choose();
}

}  // namespace pd
