// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rgl/rgl_file.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <sstream>

#include "core/io/byte_source.h"
#include "core/io/tensor_file.h"
#include "core/materials/material.h"
#include "core/math/colour.h"
#include "tests/core/io/synthetic_tensors.h"
#include "tests/support/test_program.h"

namespace rgl_brdf_test {
using namespace gonio;
using namespace gonio::test;
namespace fs = std::filesystem;

/// With the directions in the file's own order.
rgl::RglFile read(const Bytes& bytes) {
  rgl::RglFile file = rgl::readRgl(io::MemorySource(bytes));
  file.brdf = file.brdf->withIncident(IncidentDirection::light);
  return file;
}
Rgb value(const SyntheticRgl& rgl, const Direction& wi, const Direction& wo) {
  return read(rgl.file()).brdf->evaluate(wi, wo);
}
fs::path rglPath(const std::string& name) { return fs::path(GONIO_SHARED_DIR) / "data/rgl" / (name + "_rgb.bsdf"); }
Direction mirror(const Direction& w, const Direction& m) { return 2 * glm::dot(w, m) * m - w; }
bool close(double a, double b, double relative) {
  return std::abs(a - b) <= relative * std::max(std::abs(a), std::abs(b));
}

/// The tensors of a real file, and what its evaluation must give at a node of the vndf's grid, straight from the sums.
struct Tensors {
  io::TensorFile file;
  std::vector<float> theta, vndf, ndf, sigma, rgb;

  explicit Tensors(const fs::path& path)
      : file(io::FileSource(path)),
        theta(file.floats("theta_i", 1)),
        vndf(file.floats("vndf", 4)),
        ndf(file.floats("ndf", 2)),
        sigma(file.floats("sigma", 2)),
        rgb(file.floats("rgb", 5)) {}

  /// Trapezoids along row b of slice k, up to node a.
  double rowSum(std::size_t k, std::size_t b, std::size_t a) const {
    double sum = 0;
    for (std::size_t x = 0; x < a; ++x)
      sum += (double(vndf[(k * 128 + b) * 128 + x]) + double(vndf[(k * 128 + b) * 128 + x + 1])) / 2;
    return sum;
  }
  /// Incident polar angle k, microfacet normal at column a and row b: the BRDF times cos theta_o.
  Rgb atNode(std::size_t k, std::size_t a, std::size_t b) const {
    double below = 0, all = 0;
    for (std::size_t y = 0; y < 127; ++y) {
      const double strip = (rowSum(k, y, 127) + rowSum(k, y + 1, 127)) / 2;
      all += strip;
      if (y < b) below += strip;
    }
    const double x = rowSum(k, b, a) / rowSum(k, b, 127) * 31, y = below / all * 31;
    const std::size_t column = std::min<std::size_t>(std::size_t(x), 30),
                      row = std::min<std::size_t>(std::size_t(y), 30);
    const double fx = x - double(column), fy = y - double(row);
    const double u = std::sqrt(theta[k] * 2 / pi) * 127, fu = u - std::floor(u);
    // Both rows of sigma and ndf are the same material: isotropic.
    const double area = (1 - fu) * sigma[std::size_t(u)] + (fu > 0 ? fu * sigma[std::size_t(u) + 1] : 0);
    Rgb result;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const auto node = [&](std::size_t r, std::size_t c) {
        return double(rgb[((k * 3 + channel) * 32 + r) * 32 + c]);
      };
      const double fr = (1 - fy) * ((1 - fx) * node(row, column) + fx * node(row, column + 1)) +
                        fy * ((1 - fx) * node(row + 1, column) + fx * node(row + 1, column + 1));
      result[int(channel)] = fr * ndf[a] / (4 * area);
    }
    return result;
  }
};

class RglBrdfTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// A uniform vndf warps nothing: rgb ndf / (4 sigma cos theta_o) in closed form.
  void constantTensors() {
    SyntheticRgl rgl;
    const Direction wi = fromSpherical(0.7, 0.3), wo = fromSpherical(1.1, 2.0);
    for (int channel = 0; channel < 3; ++channel)
      QVERIFY(close(value(rgl, wi, wo)[channel], 1 * 2 / (4 * 0.5) / wo.z, 1e-6));
    rgl.jacobian = 0;
    QVERIFY(close(value(rgl, wi, wo).y, 1 / wo.z, 1e-6));
  }

  /// rgb = (column, row, theta_i slice): each read back through the square's coordinates.
  void coordinatesOfTheSquare() {
    SyntheticRgl rgl;
    for (std::size_t i = 0; i < rgl.rgb.size(); ++i) {
      const std::size_t column = i % 2, row = i / 2 % 2, channel = i / 4 % 3, theta = i / 12;
      rgl.rgb[i] = float(channel == 0 ? column : channel == 1 ? row : theta);
    }
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto brdf = read(rgl.file()).brdf;
    QVERIFY(brdf->isIsotropic());
    for (int n = 0; n < 2000; ++n) {
      const double thetaI = std::acos(uniform(random)), phiI = 2 * pi * uniform(random);
      const Direction wi = fromSpherical(thetaI, phiI),
                      wo = fromSpherical(std::acos(0.01 + 0.99 * uniform(random)), 2 * pi * uniform(random));
      const Direction half = glm::normalize(wi + wo);
      const Rgb f = brdf->evaluate(wi, wo) * wo.z;
      QVERIFY(std::abs(f.x - std::sqrt(polarAngle(half) / halfPi)) < 1e-5);
      const double turn = (azimuth(half) - phiI) / (2 * pi) + 0.5;
      QVERIFY(std::abs(std::remainder(f.y - turn, 1)) < 1e-5);
      QVERIFY(std::abs(f.z - thetaI / halfPi) < 1e-5);
    }
  }

  /// Columns of the vndf 0, 1, 2: density 2x, so that a normal at u goes to u^2.
  void visibleNormalsWarpTheSquare() {
    SyntheticRgl rgl;
    for (std::size_t i = 0; i < rgl.vndf.size(); ++i) rgl.vndf[i] = float(i % 3);
    for (std::size_t i = 0; i < rgl.rgb.size(); ++i) rgl.rgb[i] = float(i % 2);
    const Direction wi = fromSpherical(0.4, 1), wo = fromSpherical(0.9, -2);
    const double u2 = polarAngle(glm::normalize(wi + wo)) / halfPi;
    QVERIFY(close(value(rgl, wi, wo).x * wo.z, u2, 1e-5));
  }

  /// An even spectrum is grey, and any spectrum the weighted sum of its wavelengths.
  void spectraAreSeenUnderDaylight() {
    const std::vector<float> wavelengths{400, 500, 560, 600, 700};
    const std::vector<double> nanometres(wavelengths.begin(), wavelengths.end());
    const std::vector<Rgb> weights = spectrumWeights(nanometres);
    const auto spectral = [&](const std::vector<float>& spectrum) {
      SyntheticRgl rgl;
      std::vector<float> spectra;  // [phi 1][theta 2][wavelength 5][2][2]
      for (int slice = 0; slice < 2; ++slice)
        for (const float value : spectrum) spectra.insert(spectra.end(), 4, value);
      std::vector<TensorField> fields = rgl.fields();
      std::erase_if(fields, [](const TensorField& field) { return field.name == "rgb"; });
      fields.push_back(floatField("wavelengths", {5}, wavelengths));
      fields.push_back(floatField("spectra", {1, 2, 5, 2, 2}, spectra));
      return read(tensorFile(fields));
    };
    const Direction wi = fromSpherical(0.3, 0), wo = fromSpherical(0.6, 2);
    const Rgb white = value(SyntheticRgl(), wi, wo);  // rgb is 1 everywhere
    const auto even = spectral({1, 1, 1, 1, 1});
    QVERIFY(even.isSpectral);
    QCOMPARE(even.grid, (std::vector<int>{1, 2, 5, 2, 2}));
    const Rgb grey = even.brdf->evaluate(wi, wo);
    const Rgb coloured = spectral({0.1f, 0.2f, 0.7f, 0.4f, 0.9f}).brdf->evaluate(wi, wo);
    const Rgb sum = 0.1 * weights[0] + 0.2 * weights[1] + 0.7 * weights[2] + 0.4 * weights[3] + 0.9 * weights[4];
    for (int c = 0; c < 3; ++c) {
      QVERIFY(close(grey[c], white[c], 1e-6));
      QVERIFY(close(coloured[c], sum[c] * white[c], 1e-6));
    }
  }

  /// Colours outside the sRGB gamut: cut, they would add up to another colour in a picture.
  void negativeValuesAreKeptAndCounted() {
    SyntheticRgl rgl;
    for (std::size_t i = 4; i < 8; ++i) rgl.rgb[i] = -0.5f;  // green at theta_i = 0
    QCOMPARE(read(rgl.file()).negativeCount, std::uint64_t(4));
    const Rgb f = value(rgl, {0, 0, 1}, fromSpherical(0.5, 1));
    QVERIFY(f.x > 0 && f.y < 0 && f.z > 0);
    const auto table = bakeTable(*read(rgl.file()).brdf, {.thetaHCount = 4, .thetaDCount = 3, .phiDCount = 6});
    for (const TabulatedBrdf::Value& baked : table->values()) QVERIFY(baked.y >= 0);
  }

  void hardCase1GrazingAndBelowIsFinite() {
    const auto brdf = read(SyntheticRgl().file()).brdf;
    for (const double z : {1e-17, 0.0, -1e-17, -1e-13, -0.3, 1e-8, 1e-4}) {
      const Direction low{std::sqrt(1 - z * z), 0, z}, up = fromSpherical(0.5, 2);
      for (const Rgb& f : {brdf->evaluate(low, up), brdf->evaluate(up, low), brdf->evaluate(low, low)}) {
        QVERIFY(std::isfinite(f.x) && f.x >= 0 && f.x <= 1000.001);
        QVERIFY(z > 0.5e-12 || f == Rgb(0));
      }
    }
    QVERIFY(brdf->evaluate({1, 0, 0}, {-1, 0, 0}) == Rgb(0));  // opposite: no half vector
    QVERIFY(std::isfinite(brdf->evaluate({0, 0, 1}, {0, 0, 1}).x));
  }

  /// A value for each incident azimuth; half a turn or mirroring must bring the direction into the measured range.
  void anisotropicAzimuthsAreReduced() {
    for (const int reduction : {1, 2, 4}) {
      SyntheticRgl rgl;
      rgl.phis = {float(-pi), float(-pi + pi / reduction), float(-pi + 2 * pi / reduction)};
      rgl.vndf.assign(54, 1);
      rgl.rgb.clear();
      for (int i = 0; i < 72; ++i) rgl.rgb.push_back(float(1 + i / 24));
      const rgl::RglFile file = read(rgl.file());
      QVERIFY(!file.brdf->isIsotropic());
      QCOMPARE(file.grid, (std::vector<int>{3, 2, 3, 2, 2}));
      for (double phi = -3.1; phi < 3.1; phi += 0.37) {
        double reduced = phi;
        if (reduction == 2 && phi > 0) reduced = phi - pi;
        if (reduction == 4) reduced = std::abs(phi) > halfPi ? -std::abs(phi) : std::abs(phi) - pi;
        const double expected = 1 + 2 * (reduced + pi) / (2 * pi / reduction);
        const Direction wo = fromSpherical(0.3, 1.9);
        QVERIFY2(close(file.brdf->evaluate(fromSpherical(0.8, phi), wo).y * wo.z, expected, 1e-5),
                 std::to_string(phi).c_str());
      }
    }
    SyntheticRgl odd;
    odd.phis = {float(-pi), -2, -1};
    odd.vndf.assign(54, 1);
    odd.rgb.assign(72, 1);
    QVERIFY(contains(errorOf([&] { read(odd.file()); }), "azimuths"));
  }

  void hardCase13ShapesMustAgree() {
    const auto error = [](const std::string& name, const TensorField& replacement) {
      std::vector<TensorField> fields = SyntheticRgl().fields();
      std::erase_if(fields, [&](const TensorField& field) { return field.name == name; });
      fields.push_back(replacement);
      return errorOf([&] { read(tensorFile(fields)); });
    };
    QVERIFY(contains(error("rgb", byteField("spectra", "x")), "wavelengths"));
    QVERIFY(contains(error("rgb", floatField("rgb", {1, 2, 1, 2, 2}, std::vector<float>(8))),
                     "expected float32 1 x 2 x 3"));
    QVERIFY(contains(error("vndf", floatField("vndf", {1, 3, 3, 3}, std::vector<float>(27, 1))), "vndf"));
    QVERIFY(contains(error("vndf", floatField("vndf", {1, 2, 3, 1}, std::vector<float>(6, 1))), "at least 2"));
    QVERIFY(contains(error("ndf", floatField("ndf", {0, 2}, {})), "ndf"));
    QVERIFY(contains(error("theta_i", floatField("theta_i", {2}, {1, 1})), "increasing"));
    QVERIFY(contains(error("theta_i", floatField("theta_i", {0}, {})), "theta_i"));
    QVERIFY(contains(error("jacobian", byteField("jacobian", "")), "jacobian"));
    QVERIFY(contains(error("sigma", byteField("x", "")), "sigma"));
  }

  /// Values by hand from the tensors of a measured file, at nodes of the incident angles and of the vndf's grid.
  void measuredFileAtGridNodes() {
    for (const std::string name : {"vch_golden_yellow", "acrylic_felt_green", "chm_light_blue"}) {
      if (!fs::exists(rglPath(name))) QSKIP("the development data is absent");
      const Tensors tensors(rglPath(name));
      const materials::Material material = materials::readMaterial(rglPath(name));
      QCOMPARE(material.source.format, std::string("RGL"));
      QCOMPARE(material.source.description, tensors.file.text("description"));
      int compared = 0;
      for (const std::size_t k : {1, 3, 5})
        for (const std::size_t a : {20, 45, 70})
          for (const std::size_t b : {10, 40, 63, 64, 90, 120}) {
            const double u = double(a) / 127, phi = double(b) / 127 * 2 * pi - pi;
            const Direction wi = fromSpherical(tensors.theta[k], 0.4);
            const Direction wo = mirror(wi, fromSpherical(u * u * halfPi, phi + 0.4));
            if (wo.z < 0.05) continue;
            ++compared;
            const Rgb expected = tensors.atNode(k, a, b), found = material.brdf->evaluate(wo, wi) * wo.z;
            for (int channel = 0; channel < 3; ++channel)
              QVERIFY2(std::abs(found[channel] - expected[channel]) < 1e-4 * maxChannel(expected) + 1e-7,
                       (name + " " + std::to_string(k) + " " + std::to_string(a) + " " + std::to_string(b)).c_str());
          }
      QVERIFY(compared > 30);
    }
  }

  /// The viewer takes the place of the incident direction, as in Mitsuba and pbrt, unless another order is asked for.
  void slotsOfTheIncidentDirection() {
    SyntheticRgl rgl;
    for (std::size_t i = 0; i < rgl.rgb.size(); ++i) rgl.rgb[i] = float(1 + i % 5);
    const auto viewer = rgl::readRgl(io::MemorySource(rgl.file())).brdf;
    const auto light = viewer->withIncident(IncidentDirection::light),
               mean = viewer->withIncident(IncidentDirection::mean);
    QVERIFY(!viewer->isReciprocal() && !light->isReciprocal() && mean->isReciprocal());
    const Direction wi = fromSpherical(0.3, 0.2), wo = fromSpherical(1.1, 2.4);
    QVERIFY(viewer->evaluate(wi, wo) == light->evaluate(wo, wi));
    QVERIFY(viewer->evaluate(wi, wo) != viewer->evaluate(wo, wi));
    QVERIFY(mean->evaluate(wi, wo) == mean->evaluate(wo, wi));
    QVERIFY(mean->evaluate(wi, wo) == (viewer->evaluate(wi, wo) + light->evaluate(wi, wo)) / 2.0);
  }

  /// A luminance that is absent, 0 or not finite changes no value, and drawing goes on.
  void luminanceIsForSamplingAlone() {
    SyntheticRgl rgl;
    const Direction wi = fromSpherical(0.3, 0.2), wo = fromSpherical(1.1, 2.4);
    const Rgb expected = value(rgl, wi, wo);
    for (const float odd : {0.f, -1.f, std::numeric_limits<float>::quiet_NaN()}) {
      std::vector<TensorField> fields = rgl.fields();
      fields.push_back(floatField("luminance", {1, 2, 2, 2}, {odd, odd, odd, odd, 1, odd, 1, 2}));
      const auto brdf = read(tensorFile(fields)).brdf;
      QVERIFY(brdf->evaluate(wi, wo) == expected);
      for (const double theta : {0.0, 0.7, 1.5}) {
        const DirectionSample drawn = brdf->sample(fromSpherical(theta, 1), {0.6, 0.2, 0.9});
        QVERIFY(std::isfinite(drawn.pdf) && drawn.pdf >= 0);
      }
    }
    std::vector<TensorField> fields = rgl.fields();
    fields.push_back(floatField("luminance", {1, 1, 2, 2}, {1, 1, 1, 1}));
    QVERIFY(contains(errorOf([&] { read(tensorFile(fields)); }), "luminance"));
  }

  /// 1, 2 and 8 polar angles of incidence: values at the nodes are the nodes'.
  void anyNumberOfPolarAngles() {
    for (const std::size_t count : {1, 2, 8}) {
      SyntheticRgl rgl;
      rgl.thetas.clear();
      rgl.rgb.clear();
      rgl.vndf.assign(9 * count, 1);
      for (std::size_t t = 0; t < count; ++t) {
        rgl.thetas.push_back(float(0.1 + 1.4 * double(t) / 8));
        rgl.rgb.insert(rgl.rgb.end(), 12, float(t + 1));
      }
      const Direction wo = fromSpherical(0.4, 2);
      for (std::size_t t = 0; t < count; ++t)
        QVERIFY(close(value(rgl, fromSpherical(rgl.thetas[t], 1), wo).x * wo.z, double(t + 1), 1e-5));
      QVERIFY(close(value(rgl, {0, 0, 1}, wo).x * wo.z, 1, 1e-5));
      QVERIFY(close(value(rgl, fromSpherical(1.57, 1), wo).x * wo.z, double(count), 1e-5));
    }
  }

  /// Where the projected area is 0 nothing is reflected, rather than infinitely much.
  void zeroSigma() {
    SyntheticRgl rgl;
    rgl.sigma = 0;
    QVERIFY(value(rgl, fromSpherical(0.3, 0), fromSpherical(0.5, 1)) == Rgb(0));
  }

  /// The file's own luminance is that of its colours in linear sRGB: the channels are in the right places.
  void luminanceOfTheNodes() {
    if (!fs::exists(rglPath("cm_toxic_green"))) QSKIP("the development data is absent");
    const io::TensorFile file{io::FileSource(rglPath("cm_toxic_green"))};
    const std::vector<float> rgb = file.floats("rgb", 5), expected = file.floats("luminance", 4);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const float* red = &rgb[i / 1024 * 3072 + i % 1024];
      QVERIFY(std::abs(luminance({red[0], red[1024], red[2048]}) - expected[i]) < 2e-4);
    }
  }

  void agreesWithTheNearMeasuredCopy() {
    const fs::path tool = fs::path(GONIO_SHARED_DIR) / "tools/make-merl",
                   folder = outputPath("io/near/x").parent_path();
    if (!fs::exists(tool)) QSKIP("the development data is absent");
    std::ostringstream command;
    command << tool << ' ' << folder << " rgl vch_golden_yellow > /dev/null";
    if (std::system(command.str().c_str()) != 0) QSKIP("make-merl does not run here");
    const materials::Material measured = materials::readMaterial(rglPath("vch_golden_yellow"));
    const materials::Material near = materials::readMaterial(folder / "vch_golden_yellow.binary");
    const auto table = meanOfOrders(measured.tabulated());
    QCOMPARE(table->validCount(), std::size_t(1111432));
    QCOMPARE(near.table->validCount(), std::size_t(1111432));  // every cell above the horizon
    std::vector<double> ratios;
    for (std::size_t cell = 0; cell < table->grid().size(); cell += 5) {
      if (!table->valid()[cell] || !table->grid().nodeWithin(cell, radians(75))) continue;
      ratios.push_back(luminance(Rgb(table->values()[cell])) / luminance(Rgb(near.table->values()[cell])));
    }
    std::ranges::nth_element(ratios, ratios.begin() + std::ptrdiff_t(ratios.size() / 2));
    const double median = ratios[ratios.size() / 2];
    QVERIFY2(median > 0.9 && median < 1.1, std::to_string(median).c_str());
    // The table holds what the file's own parameterisation gives, in the mean over both orders of the directions.
    const std::size_t cell = table->grid().index(12, 30, 70);
    const auto [wi, wo] = table->grid().directions(cell);
    const Rgb one = measured.brdf->evaluate(wi, wo), other = measured.brdf->evaluate(wo, wi);
    QVERIFY(one != other && !measured.brdf->isReciprocal());
    const Rgb sum = Rgb(glm::vec3(one)) + Rgb(glm::vec3(other));  // of what the table of both orders stores
    QVERIFY(table->values()[cell] == glm::vec3(glm::max(Rgb(0), sum / 2.0)));
  }
};

GONIO_TEST(RglBrdfTest)
}  // namespace rgl_brdf_test

#include "rgl_brdf_test.moc"
