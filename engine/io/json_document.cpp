#include "engine/io/json_document.hpp"

#include <algorithm>

namespace windloom {
namespace {

/// Builds the document event by event, in the place of nlohmann's own builder, which keeps the last of
/// two equal keys and knows no limits.
class Builder final : public nlohmann::json_sax<JsonDocument> {
 public:
  Builder(std::string_view text, const std::string& file) : m_text(text), m_file(file) {}

  bool null() override { return value(nullptr); }
  bool boolean(bool v) override { return value(v); }
  bool number_integer(number_integer_t v) override { return value(v); }
  bool number_unsigned(number_unsigned_t v) override { return value(v); }
  bool number_float(number_float_t v, const string_t&) override { return value(v); }
  bool string(string_t& v) override { return value(std::move(v)); }
  bool binary(binary_t&) override { return refuse({}, "holds binary data"); }
  bool start_object(std::size_t) override { return open(JsonDocument::object()); }
  bool start_array(std::size_t) override { return open(JsonDocument::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    auto& members = m_open.back()->get_ref<JsonDocument::object_t&>();
    const auto same =
        std::ranges::find(members, name, [](const auto& member) -> const std::string& { return member.first; });
    if (same != members.end()) {
      m_target = &same->second;
      m_key = name;
      refuse(pointer(), "is there twice, expected each key once");
      return true;
    }
    if (members.size() >= kMaxJsonKeys) {
      return refuse(pointerOfOpen(), "has more than " + std::to_string(kMaxJsonKeys) + " keys");
    }
    m_target = &members.emplace_back(name, nullptr).second;
    m_key = std::move(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) override {
    const std::string_view before = m_text.substr(0, position > 0 ? position - 1 : 0);
    const auto line = 1 + std::ranges::count(before, '\n');
    const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0
    // The library's text begins with its own error number and place.
    std::string_view what = error.what();
    for (const std::string_view lead : {"] ", "column "}) {
      const std::size_t found = what.find(lead);
      if (found != what.npos) what.remove_prefix(found + lead.size());
    }
    if (const std::size_t colon = what.find(": "); colon < 8) what.remove_prefix(colon + 2);
    // It quotes the bytes it met, which need not be text.
    std::string message = "is not valid JSON: " + std::string(what);
    std::ranges::replace_if(
        message, [](char c) { return c < 0x20 || c > 0x7e; }, '?');
    return refuse("line " + std::to_string(line) + ", column " + std::to_string(column), std::move(message));
  }

  Result<JsonDocument> finish() {
    if (!m_problems.empty()) return Error{ErrorKind::BadInput, std::move(m_problems)};
    return std::move(m_root);
  }

 private:
  /// Puts a value at the place that is next; null where there are too many.
  JsonDocument* place(JsonDocument&& v) {
    if (++m_values > kMaxJsonValues) {
      refuse({}, "holds more than " + std::to_string(kMaxJsonValues) + " values");
      return nullptr;
    }
    if (m_open.empty()) return &(m_root = std::move(v));
    if (m_open.back()->is_array()) return &m_open.back()->get_ref<JsonDocument::array_t&>().emplace_back(std::move(v));
    return &(*m_target = std::move(v));
  }

  bool value(JsonDocument&& v) { return place(std::move(v)) != nullptr; }

  bool open(JsonDocument&& container) {
    if (m_open.size() >= kMaxJsonDepth) {
      return refuse(pointerOfOpen(), "is nested deeper than " + std::to_string(kMaxJsonDepth) + " levels");
    }
    if (!m_open.empty()) m_path.push_back(m_open.back()->is_array() ? std::to_string(m_open.back()->size()) : m_key);
    JsonDocument* placed = place(std::move(container));
    if (placed == nullptr) return false;
    m_open.push_back(placed);
    return true;
  }

  bool close() {
    m_open.pop_back();
    if (!m_path.empty()) m_path.pop_back();
    return true;
  }

  [[nodiscard]] std::string pointerOfOpen() const {
    std::string text;
    for (const std::string& part : m_path) text.append("/").append(pointerPart(part));
    return text;
  }
  [[nodiscard]] std::string pointer() const { return pointerOfOpen().append("/").append(pointerPart(m_key)); }

  bool refuse(std::string where, std::string message) {
    if (m_problems.size() < 100) m_problems.push_back({m_file, std::move(where), std::move(message)});
    return false;
  }

  std::string_view m_text;
  const std::string& m_file;
  JsonDocument m_root;
  std::vector<JsonDocument*> m_open;
  std::vector<std::string> m_path;
  JsonDocument* m_target = nullptr;
  std::string m_key;
  std::size_t m_values = 0;
  std::vector<Problem> m_problems;
};

bool isShort(const JsonDocument& value) {
  if (!value.is_structured()) return true;
  return value.size() <= 4 && std::ranges::all_of(value, [](const JsonDocument& v) { return v.is_primitive(); });
}

}  // namespace

Result<JsonDocument> parseJsonDocument(std::string_view text, const std::string& file) {
  Builder builder(text, file);
  JsonDocument::sax_parse(text.begin(), text.end(), &builder);
  return builder.finish();
}

Status checkJsonExtent(std::string_view text, std::size_t mostValues, const std::string& file) {
  const auto refuse = [&](const std::string& what) { return makeError(ErrorKind::BadInput, file, {}, what); };
  std::size_t depth = 0, values = 1;
  bool inText = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inText) {
      if (c == '\\') ++i;
      if (c == '"') inText = false;
    } else if (c == '"') {
      inText = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kMaxJsonDepth) return refuse("is nested deeper than " + std::to_string(kMaxJsonDepth) + " levels");
      ++values;
    } else if (c == ']' || c == '}') {
      if (depth > 0) --depth;
    } else if (c == ',') {
      ++values;
    }
    if (values > mostValues) return refuse("holds more than " + std::to_string(mostValues) + " values");
  }
  return Done{};
}

std::string pointerPart(std::string_view key) {
  std::string part;
  for (const char c : key) {
    if (c == '~') {
      part += "~0";
    } else if (c == '/') {
      part += "~1";
    } else {
      part += c;
    }
  }
  return part;
}

std::string describeJson(const JsonDocument& value) {
  constexpr std::size_t kLongest = 60;
  if (!isShort(value)) {
    const bool array = value.is_array();
    return std::string(array ? "an array" : "an object") + " of " + std::to_string(value.size()) +
           (array ? " values" : " keys");
  }
  std::string text = value.dump(-1, ' ', true, JsonDocument::error_handler_t::replace);
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  return text;
}

}  // namespace windloom
