#include "trial/seal.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

#include "support/files/sha256.hpp"
#include "tests/folder.hpp"

using namespace plumbline::trial;

namespace {

const Label label{"one",  {{"backlash", 2, {{"b", 0.03}}, 9.5}}, {{"joint_stop(2)"}}, 9.5, "ar1", 1.25,
                  "words"};

Envelope sealed(const Label& one) {
  return {salt("secret", one.name), as_json(one).dump()};
}

}  // namespace

TEST_CASE("a seal is the SHA-256 of salt, line feed, label") {
  const Envelope envelope{"00ff", "{}"};
  CHECK(seal(envelope) == plumbline::files::sha256("00ff\n{}"));
}

TEST_CASE("a changed label or salt breaks the seal") {
  const Envelope closed = sealed(label);
  const std::string published = seal(closed);
  CHECK(seal(closed) == published);
  for (std::size_t i = 0; i < closed.label.size(); ++i) {
    Envelope forged = closed;
    forged.label[i] = static_cast<char>(forged.label[i] ^ 1);
    CHECK(seal(forged) != published);
  }
  Envelope resalted = closed;
  resalted.salt[0] = resalted.salt[0] == '0' ? '1' : '0';
  CHECK(seal(resalted) != published);
}

TEST_CASE("a salt is determined by secret and name, and differs with either") {
  CHECK(salt("secret", "one") == salt("secret", "one"));
  CHECK(salt("secret", "one") != salt("secret", "two"));
  CHECK(salt("secret", "one") != salt("another", "one"));
  CHECK(salt("secret", "one").size() == 32);
}

TEST_CASE("labels, envelopes and seals survive a round trip") {
  const Envelope closed = sealed(label);
  const Envelope opened = parse_envelope(envelope_text(closed), "envelope.json");
  CHECK(seal(opened) == seal(closed));
  const Label read = label_from(nlohmann::json::parse(opened.label), "label");
  CHECK(as_json(read) == as_json(label));
  CHECK(parse_seals(seals_text({{"one", seal(closed)}}), "seals.json").at("one") == seal(closed));
}

TEST_CASE("an invalid label, envelope or file of seals is refused with its name") {
  const std::string other = "{\"format\": \"else\"}";
  CHECK_THROWS_WITH_AS(parse_seals(other, "other.json"), doctest::Contains("other.json"), plumbline::Error);
  CHECK_THROWS_WITH_AS(parse_envelope(other, "other.json"), doctest::Contains("salt"), plumbline::Error);
  CHECK_THROWS_WITH_AS(label_from(nlohmann::json::object(), "a label"), doctest::Contains("effects"),
                       plumbline::Error);
}
