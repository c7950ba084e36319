// The list of figures.
#include "core/named_rows.h"
#include "experiment/figure.h"
#include "sunfleck/error.h"

namespace sunfleck::engine {

const std::vector<Figure>& figures() {
    static const std::vector<Figure> all = {table1(), fig1(),  fig5(),  fig6(),  fig7(), fig8(),
                                            fig9(),   fig10(), fig11(), fig12(), fig13()};
    return all;
}

const Figure& figure_named(const std::string& name) {
    if (const Figure* figure = row_named(figures(), name)) return *figure;
    std::string known;
    for (const Figure& figure : figures()) known += (known.empty() ? "" : ", ") + figure.name;
    throw Error({"sunfleck experiment"}, "there is no figure \"" + name + "\"",
                "use some of: " + known + ", or all");
}

}  // namespace sunfleck::engine
