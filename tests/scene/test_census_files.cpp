// SPDX-License-Identifier: MIT
// Small scenes in the manner of files that others have written, with meshes and images beside them: each loads with
// nothing replaced or ignored.
#include <catch2/catch.hpp>

#include "image/image_io.h"
#include "scene/scene_text.h"

using namespace strahl;
using namespace strahl::test;

namespace {

struct CensusFile {
  const char* version;
  const char* body;
};

// clang-format off
const CensusFile census_files[] = {
    // Rough, metal, plastic, glass: what the exporters of Mitsuba 0.x write.
    {"0.6.0", R"(<bsdf type="roughconductor" id="a"><float name="alpha" value="0.1"/><string name="distribution" value="GGX"/><float name="extEta" value="1"/><rgb name="specularReflectance" value="0.9"/><rgb name="eta" value="0.2, 0.9, 1.1"/><rgb name="k" value="3.9, 2.4, 2.2"/></bsdf>)"},
    {"0.5.0", R"(<bsdf type="roughplastic" id="a"><string name="distribution" value="beckmann"/><float name="alpha" value="0.1"/><float name="intIOR" value="1.5"/><float name="extIOR" value="1"/><boolean name="nonlinear" value="true"/><texture name="diffuseReflectance" type="bitmap"><string name="filename" value="a.png"/><string name="filterType" value="trilinear"/></texture></bsdf>)"},
    {"0.6.0", R"(<bsdf type="plastic" id="a"><rgb name="diffuseReflectance" value="0.5"/><float name="intIOR" value="1.9"/><boolean name="nonlinear" value="true"/></bsdf>)"},
    {"0.6.0", R"(<bsdf type="conductor" id="a"><string name="material" value="Al"/><string name="extEta" value="air"/></bsdf>)"},
    {"0.6.0", R"(<bsdf type="roughdielectric" id="a"><float name="alpha" value="0.1"/><string name="distribution" value="ggx"/><string name="intIOR" value="bk7"/><float name="extIOR" value="1"/><spectrum name="specularTransmittance" value="1"/></bsdf>)"},
    {"0.6.0", R"(<bsdf type="thindielectric" id="a"><float name="intIOR" value="1.5"/><float name="extIOR" value="1"/></bsdf>)"},
    {"0.6.0", R"(<bsdf type="phong" id="a"><rgb name="diffuseReflectance" value="0.3"/><spectrum name="specularReflectance" value="0.2"/><float name="exponent" value="50"/></bsdf>)"},
    {"0.6.0", R"(<bsdf type="coating" id="a"><float name="intIOR" value="1.5"/><float name="extIOR" value="1"/><float name="thickness" value="1"/><rgb name="sigmaA" value="0.1, 0.2, 0.3"/><bsdf type="roughdiffuse"><rgb name="reflectance" value="0.5"/><float name="alpha" value="0.3"/></bsdf></bsdf>)"},
    {"0.6.0", R"(<bsdf type="mask" id="a"><texture name="opacity" type="bitmap"><string name="filename" value="a.png"/><float name="gamma" value="1"/></texture><bsdf type="twosided"><bsdf type="diffuse"/></bsdf></bsdf>)"},
    {"0.6.0", R"(<bsdf type="bumpmap" id="a"><texture type="scale"><float name="scale" value="2"/><texture type="bitmap"><string name="filename" value="a.png"/><float name="uvscale" value="4"/></texture></texture><bsdf type="diffuse"/></bsdf>)"},
    // Mitsuba 2 and 3.
    {"3.0.0", R"(<bsdf type="principled" id="a"><texture type="bitmap" name="base_color"><string name="filename" value="a.png"/><string name="filter_type" value="nearest"/></texture><float name="metallic" value="0.5"/><texture type="bitmap" name="roughness"><string name="filename" value="a.png"/><boolean name="raw" value="true"/></texture><float name="anisotropic" value="0.2"/><float name="spec_trans" value="0"/><float name="specular" value="0.4"/><float name="spec_tint" value="0.1"/><float name="sheen" value="0.1"/><float name="sheen_tint" value="0.1"/><float name="clearcoat" value="0.3"/><float name="clearcoat_gloss" value="0.5"/></bsdf>)"},
    {"3.0.0", R"(<bsdf type="principledthin" id="a"><rgb name="base_color" value="0.4"/><float name="diff_trans" value="0.6"/><float name="eta" value="1.3"/></bsdf>)"},
    {"2.1.0", R"(<bsdf type="normalmap" id="a"><texture type="bitmap" name="normalmap"><string name="filename" value="a.png"/><boolean name="raw" value="true"/></texture><bsdf type="roughplastic"><float name="alpha" value="0.1"/></bsdf></bsdf>)"},
    {"3.0.0", R"(<texture type="bitmap" id="t"><string name="filename" value="a.png"/><transform name="to_uv"><scale x="2" y="2"/></transform></texture><bsdf type="blendbsdf" id="a"><ref id="t" name="weight"/><bsdf type="diffuse"><ref id="t" name="reflectance"/></bsdf><bsdf type="conductor"/></bsdf>)"},
    {"2.0.0", R"(<bsdf type="roughconductor" id="a"><texture type="checkerboard" name="alpha_u"><float name="color0" value="0.1"/><float name="color1" value="0.2"/></texture><float name="alpha_v" value="0.3"/><string name="material" value="Au"/></bsdf>)"},
    {"3.0.0", R"(<bsdf type="null" id="a"/>)"},
    // Lights.
    {"0.6.0", R"(<emitter type="envmap"><string name="filename" value="a.png"/><float name="scale" value="2"/><transform name="toWorld"><rotate y="1" angle="90"/></transform></emitter>)"},
    {"3.0.0", R"(<emitter type="envmap"><string name="filename" value="a.png"/><transform name="to_world"><rotate x="1" angle="90"/></transform></emitter>)"},
    {"0.5.0", R"(<emitter type="sunsky"><float name="turbidity" value="4"/><vector name="sunDirection" x="0.3" y="0.6" z="0.1"/><float name="sunRadiusScale" value="10"/><float name="sunScale" value="2"/><float name="skyScale" value="1"/></emitter>)"},
    {"3.0.0", R"(<emitter type="projector"><texture type="bitmap" name="irradiance"><string name="filename" value="a.png"/></texture><float name="fov" value="30"/><float name="scale" value="2"/></emitter>)"},
    {"3.0.0", R"(<emitter type="spot"><texture type="bitmap" name="texture"><string name="filename" value="a.png"/></texture><rgb name="intensity" value="3"/></emitter>)"},
    {"3.0.0", R"(<shape type="rectangle"><emitter type="area"><texture type="bitmap" name="radiance"><string name="filename" value="a.png"/></texture></emitter></shape>)"},
    // Meshes, groups and media.
    {"0.6.0", R"(<shape type="obj"><string name="filename" value="m.obj"/><boolean name="faceNormals" value="true"/><transform name="toWorld"><matrix value="1 0 0 0 0 0 1 0 0 -1 0 0 0 0 0 1"/></transform></shape>)"},
    {"0.6.0", R"(<shape type="ply"><string name="filename" value="m.ply"/><float name="maxSmoothAngle" value="30"/><bsdf type="diffuse"><texture type="mesh_attribute" name="reflectance"><string name="name" value="vertex_color"/></texture></bsdf></shape>)"},
    {"3.0.0", R"(<shape type="shapegroup" id="g"><shape type="ply"><string name="filename" value="m.ply"/></shape></shape><shape type="instance"><ref id="g" name="shape"/><transform name="to_world"><translate x="1"/></transform></shape>)"},
    {"0.6.0", R"(<integrator type="volpath_simple"><integer name="maxDepth" value="10"/><boolean name="strictNormals" value="true"/></integrator><medium type="homogeneous" id="fog"><rgb name="sigmaS" value="1"/><rgb name="sigmaA" value="0.1"/><float name="scale" value="2"/><phase type="hg"><float name="g" value="0.5"/></phase></medium><shape type="cube"><ref name="interior" id="fog"/><bsdf type="null"/></shape>)"},
    {"3.0.0", R"(<medium type="homogeneous" id="fog"><rgb name="albedo" value="0.9"/><float name="sigma_t" value="2"/><boolean name="has_spectral_extinction" value="false"/><boolean name="sample_emitters" value="true"/><phase type="isotropic"/></medium><shape type="cube"><ref name="interior" id="fog"/><bsdf type="null"/></shape>)"},
    {"2.1.0", R"(<medium type="homogeneous" id="fog"><volume type="constvolume" name="albedo"><rgb name="value" value="0.9, 0.8, 0.7"/></volume></medium><shape type="cube"><ref name="interior" id="fog"/><bsdf type="null"/></shape>)"},
    // Integrators and films of Mitsuba 0.x.
    {"0.6.0", R"(<integrator type="path"><integer name="maxDepth" value="65"/><boolean name="strictNormals" value="true"/></integrator>)"},
    {"0.6.0", R"(<integrator type="bdpt"><integer name="maxDepth" value="12"/><boolean name="sampleDirect" value="true"/></integrator>)"},
    {"0.6.0", R"(<sensor type="perspective"><film type="mfilm"><integer name="width" value="1"/><integer name="height" value="1"/><string name="fileFormat" value="numpy"/><string name="pixelFormat" value="rgb"/></film></sensor>)"},
};
// clang-format on

}  // namespace

TEST_CASE("scenes that others write beside meshes and images load with nothing replaced or ignored") {
  const SceneFolder folder;
  write_image(Image{4, 4, {"R", "G", "B"}, std::vector<float>(48, 0.5F), {}}, folder.path("a.png"));
  folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("m.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
               "property float r\nproperty float g\nproperty float b\nelement face 1\n"
               "property list uchar int vertex_indices\nend_header\n"
               "0 0 0 .1 .2 .3\n1 0 0 .1 .2 .3\n0 1 0 .1 .2 .3\n3 0 1 2\n");
  for (const CensusFile& file : census_files) {
    const std::string body = file.body;
    std::string text = "<scene version=\"" + std::string(file.version) + "\">\n" + body;
    if (body.find("<bsdf type") != std::string::npos && body.find("id=\"a\"") != std::string::npos)
      text += "<shape type=\"sphere\"><ref id=\"a\"/></shape>";
    if (body.find("<sensor") == std::string::npos) text += "<sensor type=\"perspective\"/>";
    INFO(body);
    std::vector<std::string> found;
    try {
      found = shortened(load_scene(folder.write("scene.xml", text + "</scene>")).warnings);
    } catch (const SceneError& error) {
      found = shortened(error.diagnostics());
    }
    CHECK(found == std::vector<std::string>{});
  }
}
