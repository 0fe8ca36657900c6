// Work of plug-ins before a run that may take minutes.
#ifndef PD_LONG_WORK_HPP
#define PD_LONG_WORK_HPP

#include <functional>
#include <string>
#include <utility>

namespace pd {

/// A plug-in tells from time to time what it is at; a host that has set listen() may show it, others need not.
class LongWork {
 public:
  using Listener = std::function<void(const std::string& what)>;
  static void listen(Listener listener) { current() = std::move(listener); }
  static void tell(const std::string& what) {
    if (current()) current()(what);
  }

 private:
  static Listener& current() {
    static Listener listener;
    return listener;
  }
};

}  // namespace pd

#endif
