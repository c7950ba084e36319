// Numbers of substances that pbrt-v4 has no name for: dispersion formulas, metals, absorption.
//
// Source: refractiveindex.info's database (CC0), after the authors named with each; PMMA and
// polystyrene: the same form of formula, checked against the table of Sultanova et al. 2009.
#pragma once

#include <array>
#include <cstddef>

namespace sunfleck::engine::index_data {

/// A dispersion formula: n^2 = 1 + sum of b w^2 / (w^2 - c), w the wavelength in micrometres.
struct Sellmeier {
    struct Term {
        double b = 0;
        double c = 0;  // squared micrometres
    };
    std::array<Term, 4> terms{};  // those not needed are zero
};

/// Schott, catalogue of 2017.
inline constexpr Sellmeier kF2{
    {{{1.34533359, 0.00997743871}, {0.209073176, 0.0470450767}, {0.937357162, 111.886764}}}};
/// Malitson, J. Opt. Soc. Am. 55 (1965).
inline constexpr Sellmeier kFusedSilica{{{{0.6961663, 0.0684043 * 0.0684043},
                                          {0.4079426, 0.1162414 * 0.1162414},
                                          {0.8974794, 9.896161 * 9.896161}}}};
/// Malitson, Appl. Opt. 2 (1963).
inline constexpr Sellmeier kFluorite{{{{0.5675888, 0.050263605 * 0.050263605},
                                       {0.4710914, 0.1003909 * 0.1003909},
                                       {3.8484723, 34.64904 * 34.64904}}}};
/// Malitson and Dodge, J. Opt. Soc. Am. 62 (1972): ordinary ray.
inline constexpr Sellmeier kSapphire{{{{1.4313493, 0.0726631 * 0.0726631},
                                       {0.65054713, 0.1193242 * 0.1193242},
                                       {5.3414021, 18.028251 * 18.028251}}}};
/// Peter, Z. Phys. 15 (1923).
inline constexpr Sellmeier kDiamond{{{{0.3306, 0.175 * 0.175}, {4.3356, 0.106 * 0.106}}}};
/// Daimon and Masumura, Appl. Opt. 46 (2007): 20 degrees Celsius.
inline constexpr Sellmeier kWater{{{{0.5684027565, 0.005101829712},
                                    {0.1726177391, 0.01821153936},
                                    {0.02086189578, 0.02620722293},
                                    {0.1130748688, 10.69792721}}}};
/// Sultanova et al., Acta Phys. Pol. A 116 (2009), as the next two.
inline constexpr Sellmeier kPmma{{{{1.1819, 0.011313}}}};
inline constexpr Sellmeier kPolycarbonate{{{{1.4182, 0.021304}}}};
inline constexpr Sellmeier kPolystyrene{{{{1.4435, 0.020216}}}};

/// Clear soda-lime glass (Rubin, Sol. Energy Mater. 12, 1985): n = a + b w^2 + c / w^2.
inline constexpr std::array<double, 3> kSodaLime = {1.5130, -0.003169, 0.003962};

/// Its absorption: wavelength (nm), extinction coefficient.
inline constexpr std::array<std::array<double, 2>, 25> kSodaLimeK = {
    {{360, 5.419e-7}, {380, 5.936e-7}, {400, 2.047e-7}, {420, 2.279e-7}, {440, 2.342e-7},
     {460, 1.669e-7}, {480, 1.683e-7}, {500, 1.492e-7}, {520, 1.582e-7}, {540, 1.988e-7},
     {560, 2.529e-7}, {580, 3.563e-7}, {600, 4.548e-7}, {620, 5.972e-7}, {640, 7.754e-7},
     {660, 9.108e-7}, {680, 1.097e-6}, {700, 1.234e-6}, {720, 1.466e-6}, {740, 1.706e-6},
     {760, 1.956e-6}, {780, 2.214e-6}, {800, 2.477e-6}, {820, 2.755e-6}, {840, 3.022e-6}}};
/// Of water (Hale and Querry, Appl. Opt. 12, 1973).
inline constexpr std::array<std::array<double, 2>, 21> kWaterK = {
    {{350, 6.5e-9},   {375, 3.5e-9},  {400, 1.86e-9}, {425, 1.3e-9},  {450, 1.02e-9},
     {475, 9.35e-10}, {500, 1e-9},    {525, 1.32e-9}, {550, 1.96e-9}, {575, 3.6e-9},
     {600, 1.09e-8},  {625, 1.39e-8}, {650, 1.64e-8}, {675, 2.23e-8}, {700, 3.35e-8},
     {725, 9.15e-8},  {750, 1.56e-7}, {775, 1.48e-7}, {800, 1.25e-7}, {825, 1.82e-7},
     {850, 2.93e-7}}};

/// Metals: wavelength (nm), index, extinction coefficient (Johnson and Christy, Phys. Rev. B 9,
/// 1974).
inline constexpr std::array<std::array<double, 3>, 19> kChromium = {{{342, 1.76, 2.58},
                                                                     {354, 1.84, 2.64},
                                                                     {368, 1.87, 2.69},
                                                                     {381, 1.92, 2.74},
                                                                     {397, 2, 2.83},
                                                                     {413, 2.08, 2.93},
                                                                     {431, 2.19, 3.04},
                                                                     {451, 2.33, 3.14},
                                                                     {471, 2.51, 3.24},
                                                                     {496, 2.75, 3.3},
                                                                     {521, 2.94, 3.33},
                                                                     {549, 3.18, 3.33},
                                                                     {582, 3.22, 3.3},
                                                                     {617, 3.17, 3.3},
                                                                     {659, 3.09, 3.34},
                                                                     {704, 3.05, 3.39},
                                                                     {756, 3.08, 3.42},
                                                                     {821, 3.2, 3.48},
                                                                     {892, 3.3, 3.52}}};
inline constexpr std::array<std::array<double, 3>, 19> kIron = {{{342, 1.85, 2.27},
                                                                 {354, 1.93, 2.35},
                                                                 {368, 2.02, 2.43},
                                                                 {381, 2.12, 2.5},
                                                                 {397, 2.24, 2.58},
                                                                 {413, 2.35, 2.65},
                                                                 {431, 2.48, 2.71},
                                                                 {451, 2.59, 2.77},
                                                                 {471, 2.67, 2.82},
                                                                 {496, 2.74, 2.88},
                                                                 {521, 2.86, 2.91},
                                                                 {549, 2.95, 2.93},
                                                                 {582, 2.94, 2.99},
                                                                 {617, 2.88, 3.05},
                                                                 {659, 2.92, 3.1},
                                                                 {704, 2.86, 3.19},
                                                                 {756, 2.87, 3.28},
                                                                 {821, 2.94, 3.39},
                                                                 {892, 2.96, 3.56}}};
inline constexpr std::array<std::array<double, 3>, 19> kTitanium = {{{342, 1.72, 2.82},
                                                                     {354, 1.82, 2.87},
                                                                     {368, 1.9, 2.9},
                                                                     {381, 1.99, 2.93},
                                                                     {397, 2.08, 2.95},
                                                                     {413, 2.14, 2.98},
                                                                     {431, 2.21, 3.01},
                                                                     {451, 2.27, 3.04},
                                                                     {471, 2.32, 3.1},
                                                                     {496, 2.36, 3.19},
                                                                     {521, 2.44, 3.3},
                                                                     {549, 2.54, 3.43},
                                                                     {582, 2.6, 3.58},
                                                                     {617, 2.67, 3.72},
                                                                     {659, 2.76, 3.84},
                                                                     {704, 2.86, 3.96},
                                                                     {756, 3, 4.01},
                                                                     {821, 3.21, 4.01},
                                                                     {892, 3.29, 3.96}}};

}  // namespace sunfleck::engine::index_data
