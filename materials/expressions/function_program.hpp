// Texts of functions, compiled once: of decks, in whatever host.
#ifndef PD_FUNCTION_PROGRAM_HPP
#define PD_FUNCTION_PROGRAM_HPP

#include <memory>
#include <string>
#include <vector>

namespace pd {

/// What "-x^2" means: -(x^2) in mathematics and in our decks, (-x)^2 in Peridigm's.
enum class MinusSign { AfterPower, BeforePower };

/// A muParser expression, or the C-like body that Peridigm's functions have: assignments to `value`, local variables,
/// if/else. It ends, since there are no loops, and reaches nothing but its variables. Not to be evaluated by several
/// threads at once.
class FunctionProgram {
 public:
  /// Throws std::invalid_argument where the text cannot be understood.
  FunctionProgram(const std::string& text, const std::vector<std::string>& variables,
                  MinusSign minusSign = MinusSign::AfterPower);
  ~FunctionProgram();
  FunctionProgram(FunctionProgram&&) noexcept;

  /// `values`: one for each variable, in their order. The result may be NaN or infinite. It is NaN where any part that
  /// was evaluated has no value (sqrt(-1), 0/0), though a comparison, min() or an if made a number of it again.
  double evaluate(const double* values) const;
  bool uses(std::size_t variable) const;

  struct Statement;
  struct Implementation;

 private:
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pd

#endif
