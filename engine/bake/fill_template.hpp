#pragma once
// Text templates of the sidecars (engine/bake/sidecars): "@KEY@" is replaced by a value; lines between "@if KEY" and
// "@end" stay where KEY has a value other than "" and "0".

#include <map>
#include <string>
#include <string_view>

namespace windloom {

using TemplateValues = std::map<std::string, std::string, std::less<>>;

/// A name in capitals between two @ that has no value, and an @if without its @end, are broken promises.
std::string fillTemplate(std::string_view text, const TemplateValues& values);

/// The template of that file name; an unknown one is a broken promise.
std::string_view sidecarTemplate(std::string_view name);

}  // namespace windloom
