// How much named substances scatter and absorb, as linear sRGB, per millimetre: pbrt-v4's presets.
//
// Source: Jensen et al., A Practical Model for Subsurface Light Transport (2001): the first twelve.
// Narasimhan et al., Acquiring Scattering Properties of Participating Media by Dilution (2006).
#pragma once

#include "math/vector.h"
#include "sunfleck/error.h"

#include <array>
#include <string>
#include <string_view>

namespace sunfleck::engine {

struct Substance {
    std::string_view word;
    Vec3 scattering;  // reduced: as if all directions were alike
    Vec3 absorption;
};

// clang-format off
inline const std::array<Substance, 47> kSubstances = {{
    {"Apple", {2.29F, 2.39F, 1.97F}, {0.003F, 0.0034F, 0.046F}},
    {"Chicken1", {0.15F, 0.21F, 0.38F}, {0.015F, 0.077F, 0.19F}},
    {"Chicken2", {0.19F, 0.25F, 0.32F}, {0.018F, 0.088F, 0.2F}},
    {"Cream", {7.38F, 5.47F, 3.15F}, {0.0002F, 0.0028F, 0.0163F}},
    {"Ketchup", {0.18F, 0.07F, 0.03F}, {0.061F, 0.97F, 1.45F}},
    {"Marble", {2.19F, 2.62F, 3.0F}, {0.0021F, 0.0041F, 0.0071F}},
    {"Potato", {0.68F, 0.7F, 0.55F}, {0.0024F, 0.009F, 0.12F}},
    {"Skimmilk", {0.7F, 1.22F, 1.9F}, {0.0014F, 0.0025F, 0.0142F}},
    {"Skin1", {0.74F, 0.88F, 1.01F}, {0.032F, 0.17F, 0.48F}},
    {"Skin2", {1.09F, 1.59F, 1.79F}, {0.013F, 0.07F, 0.145F}},
    {"Spectralon", {11.6F, 20.4F, 14.9F}, {0.0F, 0.0F, 0.0F}},
    {"Wholemilk", {2.55F, 3.21F, 3.77F}, {0.0011F, 0.0024F, 0.014F}},
    {"Lowfat Milk", {0.89187F, 1.5136F, 2.532F}, {0.002875F, 0.00575F, 0.0115F}},
    {"Reduced Milk", {2.4858F, 3.1669F, 4.5214F}, {0.0025556F, 0.0051111F, 0.012778F}},
    {"Regular Milk", {4.5513F, 5.8294F, 7.136F}, {0.0015333F, 0.0046F, 0.019933F}},
    {"Espresso", {0.72378F, 0.84557F, 1.0247F}, {4.7984F, 6.5751F, 8.8493F}},
    {"Mint Mocha Coffee", {0.31602F, 0.38538F, 0.48131F}, {3.772F, 5.8228F, 7.82F}},
    {"Lowfat Soy Milk", {0.30576F, 0.34233F, 0.61664F}, {0.0014375F, 0.0071875F, 0.035937F}},
    {"Regular Soy Milk", {0.59223F, 0.73866F, 1.4693F}, {0.0019167F, 0.0095833F, 0.065167F}},
    {"Lowfat Chocolate Milk", {0.64925F, 0.83916F, 1.1057F}, {0.0115F, 0.0368F, 0.1564F}},
    {"Regular Chocolate Milk", {1.4585F, 2.1289F, 2.9527F}, {0.010063F, 0.043125F, 0.14375F}},
    {"Coke", {8.9053e-05F, 8.372e-05F, 0.0F}, {0.10014F, 0.16503F, 0.2468F}},
    {"Pepsi", {6.1697e-05F, 4.2564e-05F, 0.0F}, {0.091641F, 0.14158F, 0.20729F}},
    {"Sprite", {6.0306e-06F, 6.4139e-06F, 6.5504e-06F}, {0.001886F, 0.0018308F, 0.0020025F}},
    {"Gatorade", {0.0024574F, 0.003007F, 0.0037325F}, {0.024794F, 0.019289F, 0.008878F}},
    {"Chardonnay", {1.7982e-05F, 1.3758e-05F, 1.2023e-05F}, {0.010782F, 0.011855F, 0.023997F}},
    {"White Zinfandel", {1.7501e-05F, 1.9069e-05F, 1.288e-05F}, {0.012072F, 0.016184F, 0.019843F}},
    {"Merlot", {2.1129e-05F, 0.0F, 0.0F}, {0.11632F, 0.25191F, 0.29434F}},
    {"Budweiser Beer", {2.4356e-05F, 2.4079e-05F, 1.0564e-05F}, {0.011492F, 0.024911F, 0.057786F}},
    {"Coors Light Beer", {5.0922e-05F, 4.301e-05F, 0.0F}, {0.006164F, 0.013984F, 0.034983F}},
    {"Clorox", {0.0024035F, 0.0031373F, 0.003991F}, {0.0033542F, 0.014892F, 0.026297F}},
    {"Apple Juice", {0.00013612F, 0.00015836F, 0.000227F}, {0.012957F, 0.023741F, 0.052184F}},
    {"Cranberry Juice", {0.00010402F, 0.00011646F, 7.8139e-05F}, {0.039437F, 0.094223F, 0.12426F}},
    {"Grape Juice", {5.382e-05F, 0.0F, 0.0F}, {0.10404F, 0.23958F, 0.29325F}},
    {"Ruby Grapefruit Juice", {0.011002F, 0.010927F, 0.011036F}, {0.085867F, 0.18314F, 0.25262F}},
    {"White Grapefruit Juice", {0.22826F, 0.23998F, 0.32748F}, {0.0138F, 0.018831F, 0.056781F}},
    {"Shampoo", {0.0007176F, 0.0008303F, 0.0009016F}, {0.014107F, 0.045693F, 0.061717F}},
    {"Strawberry Shampoo", {0.00015671F, 0.00015947F, 1.518e-05F}, {0.01449F, 0.05796F, 0.075823F}},
    {"Head & Shoulders Shampoo", {0.023805F, 0.028804F, 0.034306F},
     {0.084621F, 0.15688F, 0.20365F}},
    {"Lemon Tea Powder", {0.040224F, 0.045264F, 0.051081F}, {2.4288F, 4.5757F, 7.2127F}},
    {"Orange Powder", {0.00015617F, 0.00017482F, 0.0001762F}, {0.001449F, 0.003441F, 0.007863F}},
    {"Pink Lemonade Powder", {0.00012103F, 0.00013073F, 0.00012528F},
     {0.001165F, 0.002366F, 0.003195F}},
    {"Cappuccino Powder", {1.8436F, 2.5851F, 2.1662F}, {35.844F, 49.547F, 61.084F}},
    {"Salt Powder", {0.027333F, 0.032451F, 0.031979F}, {0.28415F, 0.3257F, 0.34148F}},
    {"Sugar Powder", {0.00022272F, 0.00025513F, 0.000271F}, {0.012638F, 0.031051F, 0.050124F}},
    {"Suisse Mocha Powder", {2.7979F, 3.5452F, 4.3365F}, {17.502F, 27.004F, 35.433F}},
    {"Pacific Ocean Surface Water", {0.0001764F, 0.00032095F, 0.00019617F},
     {0.031845F, 0.031324F, 0.030147F}},
}};
// clang-format on

/// @throws Error when there is none of that name. @param from  that which names it.
const Substance& substance_of(const std::string& name, const SourceLocation& from);

}  // namespace sunfleck::engine
