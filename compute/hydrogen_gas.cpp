// Hydrogen_Gas: hydrogen that dissolving magnesium has evolved, mL per cm2 of the first surface.
//
// Mg + 2 H2O = Mg(OH)2 + H2: one mole a mole of metal. The gas is ideal and dry, V = n R T/p; beside water, whose
// vapour fills its share of a burette, Pressure is that of the hydrogen alone.
#include "loss_per_surface.hpp"
#include "plugins.hpp"

namespace pd {

class HydrogenGas : public LossPerSurface {
 public:
  struct Fields : LossPerSurface::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : LossPerSurface::Fields(parameters, "mL/cm2", "Hydrogen evolved since the start.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    LossPerSurface::declareParameters(declarations, "Hydrogen_Gas");
    declarations
        .real("Gas Per Metal", "1", "Moles of hydrogen for a mole of metal: 1 for magnesium, whose valence is 2.")
        .positive()
        .defaultTo(1.0);
    declarations.real("Temperature", "K", "At which the volume of the gas is measured.").positive().defaultTo(298.15);
    declarations.real("Pressure", "Pa", "Of the dry gas that is measured.").positive().defaultTo(101325.0);
  }
  HydrogenGas(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : LossPerSurface(completeParameters<HydrogenGas>(params, "Hydrogen_Gas"), params, comm, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }

  int compute(Blocks blocks) const override {
    constexpr double gasConstant = 8.31446261815324;          // J/(mol K), CODATA 2018, exact
    constexpr double millilitresPerSquareCentimetre = 100.0;  // of a metre
    const double molarVolume =
        gasConstant * parameters_.get<double>("Temperature") / parameters_.get<double>("Pressure");
    const double gas = parameters_.get<double>("Gas Per Metal") * amounts(blocks).dissolved * molarVolume;
    setGlobal(blocks, fields_.result, millilitresPerSquareCentimetre * gas / firstSurface(blocks));
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::HydrogenGas;
PD_REGISTER_COMPUTE(HydrogenGas, "Hydrogen_Gas",
                    "Hydrogen that dissolving metal has evolved, mL per cm2 of the first surface.")
