#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/output/text.h"
#include "tools/view/packed_session.h"

namespace tumble::tools {

/// The page that shows one session, or two of them, whole in one text. It loads nothing from anywhere.
struct SessionPage {
  Json head;                          ///< {"mode": "sent" or "served", "logs": [head_json()]}
  std::vector<PackedSession> packed;  ///< of a page to send: one a log
  std::string difference;             ///< likewise: difference_data() by zlib; empty for one log
  [[nodiscard]] std::string html() const;
};

/// Bytes of a page without its data.
std::size_t empty_page_bytes();

/// The policy of the page, for the header of a reply: no script but the page's own runs, and nothing is loaded from
/// elsewhere. served: it may ask its own server.
std::string page_policy(bool served);

}  // namespace tumble::tools
