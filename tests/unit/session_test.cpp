// What a parallel session sets up for the whole process.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <string>

namespace pd {
namespace {

TEST(SessionTest, DenseLinearAlgebraUsesWhatTheProcessorCanDo) {
  auto* const core = reinterpret_cast<char* (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_corename"));
  if (core == nullptr) GTEST_SKIP() << "BLAS is none that chooses its loops";
#if defined(__x86_64__)
  // OpenBLAS' last resort on processors of Intel that it does not know.
  const bool isOlder = !__builtin_cpu_supports("avx2");
  EXPECT_TRUE(isOlder || std::string(core()) != "Prescott");
#endif
}

}  // namespace
}  // namespace pd
