#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/kernels/faces.hpp"

namespace {
std::atomic<long> allocations{0};
}

// Not inlined: seen from the inside, a delete that frees what malloc gave looks like a mistake to
// the compiler.
__attribute__((noinline)) void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size > 0 ? size : 1)) return p;
  throw std::bad_alloc();
}
__attribute__((noinline)) void operator delete(void* p) noexcept { std::free(p); }
__attribute__((noinline)) void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace bodyline::test {
namespace {

TEST(Kernels, AllocateNothing) {
  const model::FaceTables tables(12, 12, 16, model::Range::whole, true);
  const model::FaceRule& rule = tables.rule();
  Face face = wavy_face(tables, 51, 1.0);
  const double *net = face.net.data(), *blend = face.blend.data();
  std::vector<double> bar(face.net.size()), out(30 * 256);
  double blend_bar[3] = {};
  for (const model::Isa isa : available_sets()) {
    const model::Kernels& k = model::kernels(isa);
    const long before = allocations;
    double total =
        k.area(rule, net, blend) + k.bending(rule, net, blend) + k.variation(rule, net, blend);
    total += k.area_pullback(rule, net, blend, 1.0, bar.data(), blend_bar);
    total += k.bending_pullback(rule, net, blend, 1.0, bar.data(), blend_bar);
    total += k.variation_pullback(rule, net, blend, 1.0, bar.data(), blend_bar);
    total += k.fold(rule, net, blend, {}) +
             k.fold_pullback(rule, net, blend, {}, 1.0, bar.data(), blend_bar);
    k.jets(rule, net, blend, 3, out.data());
    k.curvature(rule, net, blend, out.data(), out.data() + 256);
    const long after = allocations;
    EXPECT_TRUE(std::isfinite(total));
    EXPECT_EQ(after, before) << k.name;
  }
}

}  // namespace
}  // namespace bodyline::test
