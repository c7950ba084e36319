// Values, put where the type of their declaration wants them.
#include "library/statements.h"

#include "core/float_range.h"
#include "import/pbrt/parameter_parser.h"

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace sunfleck {
namespace {

using engine::ParameterType;

[[noreturn]] void refuse(const engine::Parameter& parameter, const std::string& given,
                         const std::string& wanted) {
    throw Error(parameter.where, "the parameter " + parameter.title() + " is given " + given,
                "give " + wanted);
}

std::vector<std::int32_t> whole_numbers(const engine::Parameter& parameter,
                                        const std::vector<double>& numbers) {
    std::vector<std::int32_t> whole;
    for (const double number : numbers) {
        if (std::trunc(number) != number ||
            std::abs(number) > std::numeric_limits<std::int32_t>::max())
            refuse(parameter, std::to_string(number), "whole numbers");
        whole.push_back(static_cast<std::int32_t>(number));
    }
    return whole;
}

/// Puts a value into a parameter of any type, or refuses it.
class ValueSetter {
public:
    explicit ValueSetter(engine::Parameter& parameter) : parameter_(parameter) {}

    void operator()(bool flag) const {
        if (parameter_.type != ParameterType::boolean)
            refuse(parameter_, "a truth value", wanted());
        parameter_.integers = {flag ? 1 : 0};
    }
    void operator()(const std::vector<double>& numbers) const {
        if (parameter_.type == ParameterType::integer)
            parameter_.integers = whole_numbers(parameter_, numbers);
        else if (takes_numbers())
            parameter_.numbers = checked(numbers);
        else
            refuse(parameter_, "numbers", wanted());
    }
    void operator()(const std::vector<std::int32_t>& numbers) const {
        if (parameter_.type == ParameterType::integer)
            parameter_.integers = numbers;
        else if (takes_numbers())
            parameter_.numbers.assign(numbers.begin(), numbers.end());
        else
            refuse(parameter_, "numbers", wanted());
    }
    void operator()(const std::vector<std::string>& texts) const {
        if (!takes_texts()) refuse(parameter_, "a string", wanted());
        parameter_.texts = texts;
    }

private:
    bool takes_texts() const {
        return parameter_.type == ParameterType::text ||
               parameter_.type == ParameterType::texture ||
               parameter_.type == ParameterType::spectrum;
    }
    bool takes_numbers() const {
        return parameter_.type != ParameterType::boolean &&
               parameter_.type != ParameterType::text && parameter_.type != ParameterType::texture;
    }
    std::string wanted() const {
        if (parameter_.type == ParameterType::boolean) return "true or false";
        if (parameter_.type == ParameterType::spectrum) return "numbers or a string";
        return takes_numbers() ? "numbers" : "a string";
    }
    const std::vector<double>& checked(const std::vector<double>& numbers) const {
        for (const double number : numbers)
            if (!engine::is_finite_float(number))
                refuse(parameter_, "a number that is not a finite float", "one below 3.4e38");
        return numbers;
    }

    engine::Parameter& parameter_;
};

}  // namespace

engine::Statement statement_of(const std::string& keyword, const std::string& type,
                               const Parameters& parameters, const std::string& where) {
    engine::Statement statement{keyword, type, {where}, {}, nullptr};
    for (const Parameter& given : parameters) {
        engine::Parameter parameter = engine::declared_parameter(given.declaration, {where});
        std::visit(ValueSetter(parameter), given.value.data());
        engine::check_components(parameter);
        statement.own.push_back(std::make_shared<const engine::Parameter>(std::move(parameter)));
    }
    return statement;
}

}  // namespace sunfleck
