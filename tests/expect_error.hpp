// Messages of errors that tests ask for.
#ifndef PD_TEST_EXPECT_ERROR_HPP
#define PD_TEST_EXPECT_ERROR_HPP

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace pd::test {

/// The message of the error of kind Error that `work` throws.
template <class Error>
std::string errorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace pd::test

#define EXPECT_CONTAINS(text, part) EXPECT_NE(std::string(text).find(part), std::string::npos) << text

#endif
