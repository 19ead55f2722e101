// The list of the fields of inputs: log, chain and comparison each cover every field that the list has.
#include <gtest/gtest.h>

#include <concepts>
#include <span>
#include <string>
#include <vector>

#include "replay/codec/header_codec.h"
#include "replay/diff/input_difference.h"
#include "replay/format/chain.h"
#include "src/model/command_fields.h"

namespace tumble::replay {
namespace {

/// Changes the field that is number `wanted` in the walk, parts taken apart.
struct ChangeField {
  std::size_t wanted;
  std::size_t next = 0;
  std::string name = {};  // of the changed field
  bool effect = false;    // whether the change changes what happens

  template <class Tag, class Value>
  void operator()(Tag tag, Value& value) {
    if constexpr (std::derived_from<Tag, sim::role::Part>) {
      sim::for_each_field(value, *this);
    } else if (next++ == wanted) {
      name = tag.kName;
      effect = !std::derived_from<Tag, sim::role::Look>;
      change(value);
    }
  }
  static void change(bool& value) { value = !value; }
  static void change(double& value) { value += 1; }
  static void change(sim::BodyId& value) { value += 1; }
  static void change(sim::Vec3& value) { value.y() += 1; }
  static void change(sim::Quat& value) { value.x += 1; }
  static void change(sim::Texture& value) { value = sim::Texture::kBrick; }
  static void change(sim::Origin& value) { value.row += 1; }
};

std::vector<sim::Command> one_of_each() {
  return {sim::Throw{},      sim::Push{}, sim::Push{3, {1, 0, 0}, false, {0, 0, 1}},
          sim::Remove{},     sim::Wake{}, sim::SetVelocity{},
          sim::SetGravity{}, sim::SetDt{}};
}

Hash128 chain_over(const sim::Command& command) {
  StepRecord record;
  record.inputs = {command};
  return chain_next({}, record);
}

sim::Command through_log(const sim::Command& command) {
  LogHeader header;
  header.scene.inputs = {{1, command}};
  const Result<MessageBytes> message = encode_header(header);
  EXPECT_TRUE(message.ok());
  const Result<LogHeader> read = decode_header(*message);
  EXPECT_TRUE(read.ok()) << read.error().message;
  return read->scene.inputs.at(0).command;
}

TEST(InputFields, EveryFieldIsLoggedHashedAndCompared) {
  std::size_t fields = 0;
  for (const sim::Command& command : one_of_each()) {
    for (std::size_t k = 0;; ++k) {
      sim::Command changed = command;
      ChangeField change{k};
      sim::for_each_field(changed, change);
      if (change.name.empty()) break;
      ++fields;
      SCOPED_TRACE(std::string(sim::name_of(command)) + "." + change.name);
      EXPECT_NE(changed, command);
      EXPECT_EQ(through_log(changed), changed);
      const auto* push = std::get_if<sim::Push>(&command);
      const bool unread = change.name == "at" && push != nullptr && push->at_centre;
      const bool effect = change.effect && !unread;
      EXPECT_EQ(chain_over(changed) != chain_over(command), effect);
      const auto found = first_difference(std::span(&command, 1), std::span(&changed, 1));
      ASSERT_EQ(found.has_value(), effect);
      const std::string wanted = std::string(sim::name_of(command)) + "." + change.name;
      EXPECT_TRUE(!found || found->field.starts_with(wanted)) << found->field;
    }
  }
  EXPECT_EQ(fields, 14U + 4 + 4 + 1 + 1 + 3 + 1 + 1);
}

TEST(InputFields, KindsAreNamedInTheOrderOfTheAlternatives) {
  std::vector<std::string> names;
  for (const sim::Command& command : one_of_each()) names.emplace_back(sim::name_of(command));
  EXPECT_EQ(names, (std::vector<std::string>{"throw", "push", "push", "remove", "wake", "set_velocity", "set_gravity",
                                             "set_dt"}));
}

}  // namespace
}  // namespace tumble::replay
