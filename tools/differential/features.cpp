// The rules of the table; what stands in it is in scene_features.cpp.
#include "differential/features.h"

#include "sunfleck/error.h"

#include <algorithm>

namespace sunfleck::engine::differential {

FeatureTable::FeatureTable(std::vector<Feature> features) : features_(std::move(features)) {
    for (const Feature& feature : features_) {
        std::vector<Condition>& conditions = conditions_.emplace_back();
        for (const Need& need : feature.needs) {
            Condition condition{index_of(need.feature), {}};
            const std::vector<std::string>& known = features_[condition.feature].values;
            for (Value value = 0; value < known.size(); ++value)
                if (std::count(need.values.begin(), need.values.end(), known[value]) > 0)
                    condition.values.push_back(value);
            conditions.push_back(std::move(condition));
        }
    }
}

std::size_t FeatureTable::index_of(std::string_view name) const {
    for (std::size_t i = 0; i < features_.size(); ++i)
        if (features_[i].name == name) return i;
    throw Error({"features"}, "no feature is called \"" + std::string(name) + '"',
                "use a name of tools/differential/scene_features.cpp");
}

bool FeatureTable::has_meaning(const Choice& choice, std::size_t feature) const {
    const std::vector<Condition>& all = conditions_[feature];
    return std::all_of(all.begin(), all.end(), [&](const Condition& condition) {
        const std::vector<Value>& values = condition.values;
        return std::count(values.begin(), values.end(), choice[condition.feature]) > 0 &&
               has_meaning(choice, condition.feature);
    });
}

std::string_view FeatureTable::value(const Choice& choice, std::string_view feature) const {
    const std::size_t index = index_of(feature);
    if (!has_meaning(choice, index)) return "";
    return features_[index].values[choice[index]];
}

void FeatureTable::narrow(Limits& limits, const Condition& condition) const {
    const auto found = limits.find(condition.feature);
    if (found == limits.end()) {
        limits.emplace(condition.feature, condition.values);
    } else {
        std::erase_if(found->second, [&](Value value) {
            return std::count(condition.values.begin(), condition.values.end(), value) == 0;
        });
    }
    for (const Condition& further : conditions_[condition.feature]) narrow(limits, further);
}

void FeatureTable::require(Limits& limits, std::size_t feature, Value value) const {
    narrow(limits, {feature, {value}});
}

}  // namespace sunfleck::engine::differential
