#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "replay/blame/blame_answer.h"
#include "replay/blame/body_account.h"
#include "tumble/sim/scene.h"

/// Answers about a contact instead of a body: the phases of the step that found it and prepared it.
namespace tumble::replay {

/// "the ground", "body 7".
std::string contact_name(const std::optional<sim::BodyId>& other);

/// The phases that made one contact of the account what it was when it acted on the field. Phases that left it as it
/// would have been without them are left out.
std::vector<BlameAnswer> making_of(const BodyAccount& account, const ContactFacts& facts, std::size_t field,
                                   sim::Method method);

/// The phases that left the body without any contact in the step, with the bodies that were near.
std::vector<BlameAnswer> absence_of(const BodyAccount& account, sim::Method method);

/// The rules that phases of the step did not keep for the body: what they should have done and did not.
std::vector<BlameAnswer> broken_rules_of(const BodyAccount& account);

/// The phase that left a frozen body at rest.
BlameAnswer rest_of(const BodyAccount& account, sim::Method method);

}  // namespace tumble::replay
