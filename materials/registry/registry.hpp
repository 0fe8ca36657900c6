// Self-registration of plug-ins: one macro line at the end of a plug-in's .cpp makes it known by name to the host.
#ifndef PD_REGISTRY_HPP
#define PD_REGISTRY_HPP

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "fields.hpp"
#include "parameters.hpp"

namespace pd {

/// What the registry knows of one plug-in. Args: the constructor's arguments.
template <class Base, class... Args>
struct Plugin {
  std::string name;
  std::string brief;  ///< one sentence, shown by `pdrun --list`
  std::function<ParameterDeclarations()> declare;
  std::function<Teuchos::RCP<Base>(Args...)> create;
  std::function<FieldTable()> fields;  ///< what it uses, with the default names, for pdrun --explain
  /// Of a plug-in that combines others of its kind: the key that names its parts, each of which has a sub-list of its
  /// parameters under its name. Else empty.
  std::string partsKey;
};

template <class Class, class = void>
constexpr bool describesFields = false;
template <class Class>
constexpr bool describesFields<Class, std::void_t<decltype(Class::describeFields())>> = true;
template <class Class, class = void>
constexpr bool hasPlainFields = false;
template <class Class>
constexpr bool hasPlainFields<Class, std::void_t<decltype(typename Class::Fields())>> = true;
template <class Class, class = void>
constexpr bool hasFieldsByParameters = false;
template <class Class>
constexpr bool hasFieldsByParameters<
    Class, std::void_t<decltype(typename Class::Fields(std::declval<const Teuchos::ParameterList&>()))>> = true;

template <class Class, class = void>
constexpr bool hasParts = false;
template <class Class>
constexpr bool hasParts<Class, std::void_t<decltype(Class::partsKey)>> = true;

/// The static partsKey of a plug-in class; empty where it has none.
template <class Class>
std::string partsKeyOf() {
  if constexpr (hasParts<Class>)
    return Class::partsKey;
  else
    return {};
}

/// The fields of a plug-in class: its static describeFields(), else a default Fields, or the Fields of the default
/// parameters; none where it has none of these.
template <class Class>
FieldTable fieldsOf() {
  if constexpr (describesFields<Class>)
    return Class::describeFields();
  else if constexpr (hasPlainFields<Class>)
    return typename Class::Fields();
  else if constexpr (hasFieldsByParameters<Class>)
    return typename Class::Fields(defaultsOf<Class>());
  else
    return {};
}

/// All plug-ins of one kind, by name.
template <class Base, class... Args>
class PluginRegistry {
 public:
  using Entry = Plugin<Base, Args...>;
  using Created = Teuchos::RCP<Base>;

  static PluginRegistry& self() {
    static PluginRegistry registry;
    return registry;
  }
  /// Throws std::logic_error where the name is taken.
  bool add(Entry entry) {
    if (!entries_.emplace(entry.name, entry).second)
      throw std::logic_error("two plug-ins are registered as \"" + entry.name + "\"");
    return true;
  }
  bool has(const std::string& name) const { return entries_.count(name) != 0; }
  /// Null where no plug-in has this name.
  const Entry* find(const std::string& name) const {
    const auto it = entries_.find(name);
    return it == entries_.end() ? nullptr : &it->second;
  }
  /// The plug-in that combines others. Throws std::logic_error where there is none.
  const Entry& combining() const {
    for (const auto& item : entries_)
      if (!item.second.partsKey.empty()) return item.second;
    throw std::logic_error("no plug-in of this kind combines others");
  }
  /// Throws std::invalid_argument with the known names where no plug-in has this one.
  Teuchos::RCP<Base> create(const std::string& name, Args... args) const {
    const Entry* entry = find(name);
    if (entry == nullptr) {
      std::string known;
      for (const std::string& other : names()) known += (known.empty() ? "" : ", ") + other;
      throw std::invalid_argument("unknown plug-in \"" + name + "\" (known: " + known + ")");
    }
    return entry->create(args...);
  }
  /// Sorted.
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& entry : entries_) result.push_back(entry.first);
    return result;
  }

 private:
  std::map<std::string, Entry> entries_;
};

/// Registers `Class` as `name`; returns true. Class has a static `void declareParameters(pd::ParameterDeclarations&)`
/// and a constructor with the registry's arguments.
template <class Registry, class Class>
bool registerPlugin(const char* name, const char* brief) {
  return Registry::self().add({name, brief,
                               [] {
                                 ParameterDeclarations declarations;
                                 Class::declareParameters(declarations);
                                 return declarations;
                               },
                               [](auto&&... args) ->
                               typename Registry::Created { return Teuchos::rcp(new Class(args...)); },
                               [] { return fieldsOf<Class>(); }, partsKeyOf<Class>()});
}

}  // namespace pd

/// registerPlugin() as the program starts. Use it once a .cpp, at file scope.
#define PD_REGISTER(Registry, Class, Name, Brief)                                     \
  namespace {                                                                         \
  const bool isRegistered_##Class = pd::registerPlugin<Registry, Class>(Name, Brief); \
  }

#endif
