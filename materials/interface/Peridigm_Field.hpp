// Field descriptions, with the names and signatures of Peridigm's FieldManager.
// Inside a Peridigm tree Peridigm's own header of this name is found instead.
#ifndef PERIDIGM_FIELD_HPP
#define PERIDIGM_FIELD_HPP

#include <string>
#include <vector>

namespace PeridigmNS {

namespace PeridigmField {

enum Relation { UNDEFINED_RELATION = 0, NODE, ELEMENT, BOND, GLOBAL };

enum Length {
  UNDEFINED_LENGTH = 0,
  LENGTH_1,
  LENGTH_2,
  LENGTH_3,
  LENGTH_4,
  LENGTH_5,
  LENGTH_6,
  LENGTH_7,
  LENGTH_8,
  LENGTH_9,
  SCALAR,
  VECTOR,
  SYMMETRIC_TENSOR,
  FULL_TENSOR
};

enum Temporal { UNDEFINED_TEMPORAL = 0, CONSTANT, TWO_STEP };

enum Step { UNDEFINED_STEP = 0, STEP_NONE, STEP_N, STEP_NP1 };

/// Number of values a point holds for a field of this length.
int variableDimension(Length length);

}  // namespace PeridigmField

class FieldSpec {
 public:
  FieldSpec() = default;
  FieldSpec(PeridigmField::Relation relation_, PeridigmField::Length length_, PeridigmField::Temporal temporal_,
            std::string label_, int id_)
      : relation(relation_), length(length_), temporal(temporal_), label(std::move(label_)), id(id_) {}

  PeridigmField::Relation getRelation() const { return relation; }
  PeridigmField::Length getLength() const { return length; }
  PeridigmField::Temporal getTemporal() const { return temporal; }
  std::string getLabel() const { return label; }
  int getId() const { return id; }

  PeridigmField::Relation relation = PeridigmField::UNDEFINED_RELATION;
  PeridigmField::Length length = PeridigmField::UNDEFINED_LENGTH;
  PeridigmField::Temporal temporal = PeridigmField::UNDEFINED_TEMPORAL;
  std::string label = "Undefined";
  int id = -1;
};

/// The register of all fields. A field is known by its label; asking twice for one label gives one id.
class FieldManager {
 public:
  static FieldManager& self();

  /// Registers the field, or finds it. Throws std::invalid_argument where the label is known with another
  /// description, or differs from a known label only by case.
  int getFieldId(PeridigmField::Relation relation, PeridigmField::Length length, PeridigmField::Temporal temporal,
                 std::string label);

  bool hasField(std::string label);
  /// Throws std::invalid_argument where no field has this label.
  int getFieldId(std::string label);
  FieldSpec getFieldSpec(int fieldId);
  FieldSpec getFieldSpec(std::string label);
  std::vector<FieldSpec> getFieldSpecs() { return specs; }
  std::vector<std::string> getFieldLabels();

 private:
  FieldManager() = default;
  std::vector<FieldSpec> specs;
};

}  // namespace PeridigmNS

#endif
