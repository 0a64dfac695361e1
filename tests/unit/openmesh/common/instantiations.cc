#include "instantiations.hh"

WHITTLE_TEST_INSTANTIATE(, OpenMesh::DefaultTraits)
WHITTLE_TEST_INSTANTIATE(, whittle::test::DoubleTraits)
