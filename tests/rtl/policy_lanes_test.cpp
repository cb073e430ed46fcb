// policy_core with other numbers of lanes: the same arithmetic from another layout of the image.
#include <cstddef>

#include "Vpolicy_core_16.h"
#include "Vpolicy_core_4.h"
#include "tests/rtl/policy_core_fixture.hpp"

namespace armature::test {
namespace {

using PolicyCore4 = PolicyCoreFixture<Vpolicy_core_4, 4>;
using PolicyCore16 = PolicyCoreFixture<Vpolicy_core_16, 16>;

TEST_F(PolicyCore4, HasTheBitsOfPlainArithmetic) {
  EXPECT_EQ(dut_.id_rdata_o, 0x504D'0104u);
  RandomNetworks networks{3711};
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    const TestNetwork network = networks.next();
    expect_plain_arithmetic(network, networks.inputs(network[0].neurons[0].weights.size()));
  }
  expect_plain_arithmetic(networks.of({32, 64, 64, 64, 8}), networks.inputs(32));
  EXPECT_EQ(dut_.cycles_value_o, 3113);
}

TEST_F(PolicyCore16, HasTheBitsOfPlainArithmetic) {
  EXPECT_EQ(dut_.id_rdata_o, 0x504D'0110u);
  RandomNetworks networks{3712};
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    const TestNetwork network = networks.next();
    expect_plain_arithmetic(network, networks.inputs(network[0].neurons[0].weights.size()));
  }
  expect_plain_arithmetic(networks.of({32, 64, 64, 64, 8}), networks.inputs(32));
  EXPECT_EQ(dut_.cycles_value_o, 897);
}

}  // namespace
}  // namespace armature::test
