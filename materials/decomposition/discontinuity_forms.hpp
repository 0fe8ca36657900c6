// Forms of cracks and voids by their parameters.
#ifndef PD_DISCONTINUITY_FORMS_HPP
#define PD_DISCONTINUITY_FORMS_HPP

#include <Teuchos_ParameterList.hpp>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bond_decomposition.hpp"
#include "discontinuities.hpp"
#include "parameters.hpp"

namespace pd::decomposition {

/// What one crack or void consists of.
struct DiscontinuityForm {
  std::vector<std::unique_ptr<Screen>> screens;
  std::vector<std::unique_ptr<Void>> voids;
};

/// What is wrong with the parameters of a form; what() follows their name.
class FormError : public std::invalid_argument {
 public:
  FormError(std::string wrongKey, const std::string& what) : std::invalid_argument(what), key(std::move(wrongKey)) {}
  const std::string key;  ///< empty: the whole
};

/// The parameters of a form, "Type" among them, and the dimension of the bodies that have it.
struct FormType {
  ParameterDeclarations declarations;
  int dimension;
};
/// By type.
const std::map<std::string, FormType>& crackForms();
/// By type, but for those in files.
const std::map<std::string, FormType>& voidForms();
/// Declares the key "Type" of a form.
void declareType(ParameterDeclarations& declare, const std::string& type);

/// `params`: of one of these types, with its defaults. Throw FormError.
DiscontinuityForm crackFrom(const Teuchos::ParameterList& params);
DiscontinuityForm voidFrom(const Teuchos::ParameterList& params);

DiscontinuityForm ellipsoidForm(const Ellipsoid& shape);
/// A sphere, or a circle in a plane.
DiscontinuityForm ballForm(const Place& center, double radius, int dimension);
/// A hole with these corners, which complaintOfOutline() has nothing against.
DiscontinuityForm polygonForm(const std::vector<Place>& corners);
/// Why these corners, in turn, are not the outline of a hole; empty where they are: it has an inside, and its sides
/// meet at the corners between them alone.
std::string complaintOfOutline(const std::vector<Place>& corners);

/// The keys of a DecompositionRule, and "Cracks Count In Damage".
void declareRule(ParameterDeclarations& declare);
/// `params`: with defaults or without.
DecompositionRule ruleFrom(const Teuchos::ParameterList& params);

}  // namespace pd::decomposition

#endif
