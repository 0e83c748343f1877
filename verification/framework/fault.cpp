#include "verification/framework/fault.hpp"

#include <utility>

namespace retiarius::verification {

namespace {

class ScaledLaw final : public Law {
 public:
  ScaledLaw(std::unique_ptr<Law> law, double factor) : law_(std::move(law)), factor_(factor) {}

  std::string_view name() const override { return law_->name(); }
  void couple(BlockPattern& pattern) const override { law_->couple(pattern); }
  void bind(const BlockPattern& pattern) override {
    law_->bind(pattern);
    scratch_.reset(pattern);
  }
  void prepare(const Step& step) override { law_->prepare(step); }
  double potential(const Step& step, const std::vector<Vec3>& y) const override {
    return factor_ * law_->potential(step, y);
  }

  double assemble(const Step& step, const std::vector<Vec3>& y, Assembly& out) const override {
    std::vector<Vec3> gradient(y.size(), Vec3::Zero());
    Assembly own{&gradient, out.hessian ? &scratch_ : nullptr, out.definite};
    if (out.hessian) scratch_.set_zero();
    const double value = factor_ * law_->assemble(step, y, own);
    for (std::size_t i = 0; i < y.size(); ++i) (*out.gradient)[i] += factor_ * gradient[i];
    if (!out.hessian) return value;
    for (std::size_t i = 0; i < scratch_.diagonal.size(); ++i)
      out.hessian->diagonal[i] += factor_ * scratch_.diagonal[i];
    for (std::size_t k = 0; k < scratch_.below.size(); ++k)
      out.hessian->below[k] += factor_ * scratch_.below[k];
    return value;
  }

  void account(const Step& step, const std::vector<Vec3>& y, const std::vector<Vec3>& x1,
               Exchange& exchange) const override {
    Exchange own;
    law_->account(step, y, x1, own);
    exchange.material_loss += factor_ * own.material_loss;
    exchange.environment_loss += factor_ * own.environment_loss;
    exchange.outside_impulse += factor_ * own.outside_impulse;
    exchange.outside_angular_impulse += factor_ * own.outside_angular_impulse;
  }

 private:
  std::unique_ptr<Law> law_;
  double factor_;
  mutable BlockMatrix scratch_;
};

}  // namespace

const std::vector<std::string>& fault_names() {
  static const std::vector<std::string> names = {
      "stretching",       "bending",  "gravity", "environment damping",
      "material damping", "friction", "mass"};
  return names;
}

LawWrapper law_wrapper(const Fault& fault) {
  if (fault.law.empty()) return {};
  return [fault](std::unique_ptr<Law> law) -> std::unique_ptr<Law> {
    if (!fault.hits(std::string(law->name()))) return law;
    return std::make_unique<ScaledLaw>(std::move(law), fault.factor);
  };
}

void spoil(const Fault& fault, Network& network) {
  if (fault.hits("material damping"))
    for (Material& m : network.materials) m.damping *= fault.factor;
  if (fault.hits("mass"))
    for (double& m : network.mass) m *= fault.factor;
}

void spoil(const Fault& fault, ContactSpec& contact) {
  if (fault.hits("friction")) contact.friction *= fault.factor;
}

}  // namespace retiarius::verification
