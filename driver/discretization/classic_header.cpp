#include "classic_header.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace pd {

namespace {

/// Numbers of files are at most this: sums and products stop here.
constexpr std::uint64_t countless = std::numeric_limits<std::uint64_t>::max();

std::uint64_t cappedSum(std::uint64_t a, std::uint64_t b) { return a > countless - b ? countless : a + b; }
std::uint64_t cappedProduct(std::uint64_t a, std::uint64_t b) {
  std::uint64_t product = 0;
  return __builtin_mul_overflow(a, b, &product) ? countless : product;
}
std::uint64_t padded(std::uint64_t nBytes) { return cappedSum(nBytes, 3) / 4 * 4; }

/// Bytes of a value of external type 1 (NC_BYTE) ... 11 (NC_UINT64).
std::uint64_t bytesOfType(std::uint64_t type) {
  constexpr std::string_view bytes = "\1\1\2\4\4\10\1\2\4\10\10";
  if (type < 1 || type > bytes.size()) throw std::runtime_error("its heading is damaged: type " + std::to_string(type));
  return static_cast<std::uint64_t>(bytes[type - 1]);
}

/// Goes once through a heading, whose numbers are big-endian, and never beyond the end of the file.
class HeaderWalk {
 public:
  HeaderWalk(std::ifstream& file, std::uint64_t fileSize, char version)
      : file_(file), fileSize_(fileSize), position_(4), isWide_(version == 5), offsetBytes_(version == 1 ? 4 : 8) {}

  void run() {
    const std::uint64_t nRecords = count();
    const bool recordsAreCounted = nRecords != (isWide_ ? countless : 0xffffffffu);  // else the file grows by itself
    forEachOf("dimensions", [&] {
      passText();
      lengths_.push_back(count());
    });
    passAttributes();
    forEachOf("variables", [&] { readVariable(); });
    const std::uint64_t nFollowing = recordsAreCounted && nRecords > 0 ? nRecords - 1 : 0;
    // One variable of records alone lies there without gaps.
    const std::uint64_t stride = recordSizes_.size() == 1 ? recordSizes_[0] : paddedRecord_;
    if (nRecords > 0) requireBytes(cappedSum(endOfFirstRecord_, cappedProduct(nFollowing, stride)));
  }

 private:
  std::uint64_t number(std::uint64_t nBytes) {
    pass(nBytes);
    unsigned char bytes[8] = {};
    file_.read(reinterpret_cast<char*>(bytes), static_cast<std::streamsize>(nBytes));
    if (!file_) throw std::runtime_error("its heading cannot be read");
    std::uint64_t value = 0;
    for (std::uint64_t i = 0; i < nBytes; ++i) value = value << 8 | bytes[i];
    return value;
  }
  std::uint64_t count() { return number(isWide_ ? 8 : 4); }

  /// The next bytes are in the file.
  void pass(std::uint64_t nBytes) {
    if (nBytes > fileSize_ - position_)
      throw std::runtime_error("its heading counts more than its " + std::to_string(fileSize_) + " bytes hold");
    position_ += nBytes;
  }
  void skip(std::uint64_t nBytes) {
    pass(nBytes);
    file_.seekg(static_cast<std::streamoff>(position_));
  }
  void passText() { skip(padded(count())); }
  void passAttributes() {
    forEachOf("attributes", [&] {
      passText();
      const std::uint64_t bytes = bytesOfType(number(4));
      skip(padded(cappedProduct(bytes, count())));
    });
  }
  /// A list begins with a tag, zero where it is empty; each of its entries moves on, so that the end of the file stops
  /// whatever count.
  template <class Visit>
  void forEachOf(const std::string& what, const Visit& visit) {
    number(4);
    const std::uint64_t n = count();
    // The library takes memory for as many at once; each has at least a name's length and a number.
    if (n > (fileSize_ - position_) / 8)
      throw std::runtime_error("its heading counts " + std::to_string(n) + " " + what + ", more than its " +
                               std::to_string(fileSize_) + " bytes hold");
    for (std::uint64_t i = 0; i < n; ++i) visit();
  }

  void readVariable() {
    passText();
    const std::uint64_t nDimensions = count();
    if (nDimensions > (fileSize_ - position_) / 4)
      throw std::runtime_error("its heading counts " + std::to_string(nDimensions) + " dimensions of a variable");
    std::uint64_t values = 1;
    bool hasRecords = false;
    for (std::uint64_t i = 0; i < nDimensions; ++i) {
      const std::uint64_t dimension = count();
      if (dimension >= lengths_.size())
        throw std::runtime_error("its heading is damaged: a variable has a dimension that is not there");
      const std::uint64_t length = lengths_[dimension];
      if (i == 0 && length == 0)
        hasRecords = true;  // the unlimited dimension
      else
        values = cappedProduct(values, length);
    }
    passAttributes();
    const std::uint64_t size = cappedProduct(values, bytesOfType(number(4)));
    count();  // vsize, which follows from the rest
    const std::uint64_t end = cappedSum(number(offsetBytes_), size);
    if (!hasRecords) return requireBytes(end);
    recordSizes_.push_back(size);
    paddedRecord_ = cappedSum(paddedRecord_, padded(size));
    endOfFirstRecord_ = std::max(endOfFirstRecord_, end);
  }

  void requireBytes(std::uint64_t end) const {
    if (end > fileSize_)
      throw std::runtime_error("it is cut off or damaged: it has " + std::to_string(fileSize_) +
                               " bytes, and the values that its heading announces end at " + std::to_string(end));
  }

  std::ifstream& file_;
  std::uint64_t fileSize_, position_;
  bool isWide_;
  std::uint64_t offsetBytes_;
  std::vector<std::uint64_t> lengths_, recordSizes_;
  std::uint64_t paddedRecord_ = 0, endOfFirstRecord_ = 0;
};

}  // namespace

void checkClassicHeader(const std::string& fileName) {
  std::ifstream file(fileName, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  char magic[4] = {};
  file.seekg(0);
  file.read(magic, 4);
  if (!file || std::string_view(magic, 3) != "CDF" || (magic[3] != 1 && magic[3] != 2 && magic[3] != 5)) return;
  HeaderWalk(file, static_cast<std::uint64_t>(size), magic[3]).run();
}

}  // namespace pd
