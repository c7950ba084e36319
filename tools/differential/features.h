// The table of scene features: each feature has values, one of which a scene takes.
//
// A feature has a meaning only where its needs are met: the shape of a lamp needs an area light.
// A pair of values counts as covered by a scene where both features have a meaning in it.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine::differential {

/// A feature has a meaning where another one has one of these values.
struct Need {
    std::string feature;
    std::vector<std::string> values;
};

struct Feature {
    std::string name;
    std::vector<std::string> values;
    std::vector<Need> needs;
};

/// Index of a value in Feature::values.
using Value = std::size_t;
/// One value for each feature of the table, in its order.
using Choice = std::vector<Value>;

class FeatureTable {
public:
    /// @param features  names distinct; needs name features and values of the table.
    /// @throws Error for a need of something that is not in the table.
    explicit FeatureTable(std::vector<Feature> features);

    std::size_t size() const { return features_.size(); }
    const Feature& operator[](std::size_t index) const { return features_[index]; }
    /// @throws Error for a name that is not in the table.
    std::size_t index_of(std::string_view name) const;

    /// True if all needs of the feature are met, and all needs of these in turn.
    bool has_meaning(const Choice& choice, std::size_t feature) const;
    /// The chosen value; "" where the feature has no meaning.
    std::string_view value(const Choice& choice, std::string_view feature) const;

    /// Values that remain for each feature, by index; all of those that are not named.
    using Limits = std::map<std::size_t, std::vector<Value>>;
    /// Limits under which the feature has this value and a meaning; an empty list of values where
    /// that cannot be.
    void require(Limits& limits, std::size_t feature, Value value) const;

private:
    struct Condition {
        std::size_t feature;
        std::vector<Value> values;
    };
    void narrow(Limits& limits, const Condition& condition) const;

    std::vector<Feature> features_;
    std::vector<std::vector<Condition>> conditions_;  // the needs, by index
};

/// The features of the scene language.
/// @param left_out  values that no scene takes, as "feature=value".
/// @throws Error for one that is not in the table, or for the last value of a feature.
FeatureTable scene_features(const std::vector<std::string>& left_out = {});

}  // namespace sunfleck::engine::differential
