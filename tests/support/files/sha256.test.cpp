#include "support/files/sha256.hpp"

#include <doctest/doctest.h>

TEST_CASE("the digest is SHA-256") {
  // FIPS 180-2, appendix B.1
  CHECK(plumbline::files::sha256("abc") ==
        "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}
