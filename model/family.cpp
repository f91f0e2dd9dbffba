#include "model/family.hpp"

#include <stdexcept>

#include "model/basis_bezier_like.hpp"
#include "model/basis_h_bezier.hpp"

namespace bodyline::model {
namespace {

template <Basis B>
class BasisOf final : public AnyBasis {
 public:
  explicit BasisOf(int degree) : basis_(degree) {}
  int degree() const override { return basis_.degree(); }
  int shape_count() const override { return basis_.shape_count(); }
  ShapeRange shape_range(int k) const override { return basis_.shape_range(k); }
  ShapeRange body_range(int k) const override { return basis_.body_range(k); }
  double neutral_shape(int k) const override { return basis_.neutral_shape(k); }
  int mirrored_shape(int k) const override { return basis_.mirrored_shape(k); }
  BasisJet evaluate(double t, std::span<const double> shape) const override {
    return basis_.evaluate(t, shape);
  }
  BasisJet shape_derivative(double t, std::span<const double> shape, int k) const override {
    return basis_.shape_derivative(t, shape, k);
  }
  int bezier_degree() const override { return basis_.bezier_degree(); }
  FormMatrix conversion(std::span<const double> shape) const override {
    return basis_.conversion(shape);
  }
  FormMatrix conversion_derivative(std::span<const double> shape, int k) const override {
    return basis_.conversion_derivative(shape, k);
  }
  int abscissa_degree() const override { return basis_.abscissa_degree(); }
  FormVector abscissa(std::span<const double> shape) const override {
    return basis_.abscissa(shape);
  }
  FormVector abscissa_derivative(std::span<const double> shape, int k) const override {
    return basis_.abscissa_derivative(shape, k);
  }

 private:
  B basis_;
};

template <Basis B>
std::unique_ptr<const AnyBasis> make(int degree) {
  return std::make_unique<BasisOf<B>>(degree);
}

struct Entry {
  Family family;
  std::unique_ptr<const AnyBasis> (*make)(int degree);
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> list{
      {{.name = "ge-bezier", .min_degree = 2, .joins = false}, make<GeBezierBasis>},
      {{.name = "bezier-like", .min_degree = 2, .shape_per_row = true}, make<BezierLikeBasis>},
      {{.name = "h-bezier", .min_degree = 3, .polynomial = false}, make<HBezierBasis>},
  };
  return list;
}

const Entry& find_entry(const std::string& name) {
  std::string known;
  for (const Entry& entry : entries()) {
    if (entry.family.name == name) return entry;
    known += (known.empty() ? "" : ", ") + entry.family.name;
  }
  throw std::invalid_argument("there is no basis \"" + name + "\"; known are " + known);
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> list = [] {
    std::vector<Family> result;
    for (const Entry& entry : entries()) result.push_back(entry.family);
    return result;
  }();
  return list;
}

std::vector<std::string> family_names() {
  std::vector<std::string> names;
  for (const Entry& entry : entries()) names.push_back(entry.family.name);
  return names;
}

const Family& find_family(const std::string& name) { return find_entry(name).family; }

std::unique_ptr<const AnyBasis> family(const std::string& name, int degree) {
  return find_entry(name).make(degree);
}

int mirrored_shape(const AnyBasis& basis, int k) {
  const int count = basis.shape_count(), first = k / count * count;
  return first + basis.mirrored_shape(k - first);
}

ShapeCounts shape_counts(const std::string& name, int degree_u, int degree_v) {
  const Entry& entry = find_entry(name);
  const int u = entry.make(degree_u)->shape_count(), v = entry.make(degree_v)->shape_count();
  return {u, entry.family.shape_per_row ? (degree_u + 1) * v : v};
}

}  // namespace bodyline::model
