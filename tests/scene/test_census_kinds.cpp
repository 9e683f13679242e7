// SPDX-License-Identifier: MIT
// Small scenes in the manner of files that others have written for Mitsuba 0.x, 2 and 3, kind by kind: each loads with
// nothing replaced or ignored.
#include <catch2/catch.hpp>

#include "scene/scene_text.h"

using namespace strahl;
using namespace strahl::test;

namespace {

struct CensusKind {
  const char* version;
  const char* body;
};

const CensusKind census_kinds[] =
    {
        // Integrators and samplers.
        {"0.6.0",
         R"(<integrator type="path"><integer name="maxDepth" value="65"/><boolean name="strictNormals" value="false"/></integrator>)"},
        {"0.5.0",
         R"(<integrator type="direct"><integer name="emitterSamples" value="1"/><integer name="bsdfSamples" value="1"/></integrator>)"},
        {"0.6.0",
         R"(<integrator type="volpath"><integer name="maxDepth" value="-1"/><integer name="rrDepth" value="20"/></integrator>)"},
        {"2.1.0", R"(<integrator type="volpathmis"><integer name="max_depth" value="16"/></integrator>)"},
        {"3.0.0",
         R"(<integrator type="path"><integer name="max_depth" value="8"/><integer name="samples_per_pass" value="64"/><boolean name="hide_emitters" value="True"/></integrator>)"},
        // Films and sensors.
        {"0.6.0",
         R"(<sensor type="perspective"><float name="focusDistance" value="6"/><float name="fov" value="45"/><string name="fovAxis" value="smaller"/><float name="nearClip" value="0.1"/><float name="farClip" value="100"/><film type="ldrfilm"><integer name="width" value="64"/><integer name="height" value="48"/><string name="pixelFormat" value="rgb"/><float name="gamma" value="2.2"/><boolean name="banner" value="false"/><string name="fileFormat" value="png"/><rfilter type="tent"/></film><sampler type="sobol"><integer name="sampleCount" value="64"/></sampler></sensor>)"},
        {"0.6.0",
         R"(<sensor type="perspective"><film type="hdrfilm"><float name="gamma" value="-1"/><boolean name="attachLog" value="false"/><rfilter type="gaussian"/></film><sampler type="ldsampler"><integer name="sampleCount" value="4294967296"/></sampler></sensor>)"},
        {"3.0.0",
         R"(<sensor type="thinlens"><float name="aperture_radius" value="0.1"/><float name="focus_distance" value="4"/><float name="fov" value="40"/><film type="hdrfilm"><string name="component_format" value="float32"/><boolean name="sample_border" value="true"/><rfilter type="box"/></film></sensor>)"},
        {"3.0.0",
         R"(<sensor type="orthographic"><float name="near_clip" value="0.1"/><float name="far_clip" value="50"/><sampler type="multijitter"><integer name="sample_count" value="16"/></sampler></sensor>)"},
        {"2.0.0",
         R"(<sensor type="perspective"><string name="focal_length" value="35mm"/><float name="principal_point_offset_x" value="0.01"/></sensor>)"},
        // Spectra.
        {"0.6.0",
         R"(<bsdf type="diffuse" id="white"><spectrum name="reflectance" value="400:0.343,404:0.445,408:0.551,412:0.624,500:0.73,600:0.73,712:0.738"/></bsdf>)"},
        {"2.1.0",
         R"(<shape type="rectangle"><emitter type="area"><spectrum name="radiance" value="400:0, 500:8, 600:15.6, 700:18.4"/></emitter></shape>)"},
        {"0.6.0",
         R"(<shape type="sphere"><emitter type="area"><spectrum name="radiance" value="12"/></emitter></shape>)"},
        {"0.6.0",
         R"(<shape type="sphere"><emitter type="area"><blackbody name="radiance" temperature="5000K" scale="0.001"/></emitter></shape>)"},
        {"0.5.0",
         R"(<shape type="sphere"><emitter type="area"><rgb name="radiance" value="1 2 3" intent="illuminant"/></emitter></shape>)"},
        {"0.5.0", R"(<bsdf type="diffuse"><srgb name="reflectance" value="#6d7185"/></bsdf>)"},
        {"3.0.0",
         R"(<emitter type="constant"><spectrum name="radiance" type="d65"><float name="scale" value="2"/></spectrum></emitter>)"},
        {"3.0.0",
         R"(<bsdf type="diffuse"><spectrum name="reflectance" type="uniform"><float name="value" value="0.4"/></spectrum></bsdf>)"},
        {"3.0.0",
         R"(<bsdf type="diffuse"><spectrum name="reflectance" type="irregular"><string name="wavelengths" value="400, 700"/><string name="values" value="0.2, 0.8"/></spectrum></bsdf>)"},
        {"3.0.0",
         R"(<bsdf type="diffuse"><spectrum name="reflectance" type="regular"><float name="wavelength_min" value="400"/><float name="wavelength_max" value="700"/><string name="values" value="0.2, 0.5, 0.8"/></spectrum></bsdf>)"},
        {"3.0.0",
         R"(<bsdf type="diffuse"><spectrum name="reflectance" type="srgb"><rgb name="color" value="0.1, 0.2, 0.3"/></spectrum></bsdf>)"},
        {"3.0.0",
         R"(<emitter type="point"><spectrum name="intensity" type="blackbody"><float name="temperature" value="3000"/></spectrum></emitter>)"},
        {"3.0.0",
         R"(<bsdf type="dielectric"><texture type="rawconstant" name="specular_transmittance"><vector name="value" value="0.5, 0.6, 0.7"/></texture></bsdf>)"},
        // Emitters.
        {
            "0.6.0", R"(<emitter type="spot"><transform name="toWorld"><lookAt origin="0,5,0" target="0,0,0" up="1,0,0"/></transform><rgb name="intensity" value="10"/><float name="cutoffAngle" value="30"/><float name="beamWidth" value="20"/></emitter>)"},
        {"3.0.0",
         R"(<emitter type="spot"><transform name="to_world"><lookat origin="0,5,0" target="0,0,0" up="1,0,0"/></transform><spectrum name="intensity" value="400:1, 700:2"/><float name="cutoff_angle" value="30"/><float name="sampling_weight" value="2"/></emitter>)"},
        {"3.0.0",
         R"(<emitter type="directional"><vector name="direction" x="0" y="-1" z="0"/><rgb name="irradiance" value="3"/></emitter>)"},
        {"0.6.0",
         R"(<shape type="rectangle"><emitter type="area"><rgb name="radiance" value="5"/><float name="samplingWeight" value="0.5"/></emitter></shape>)"},
        {"2.0.0",
         R"(<emitter type="point"><transform name="to_world"><translate x="1" y="2" z="3"/></transform><rgb name="intensity" value="100"/></emitter>)"},
        // Materials, references and folders.
        {"0.6.0",
         R"(<path value="."/><bsdf type="dielectric" id="glass"><string name="intIOR" value="bk7"/><string name="extIOR" value="air"/></bsdf><shape type="sphere"><ref id="glass"/></shape>)"},
        {"0.6.0",
         R"(<bsdf type="twosided" id="wall"><bsdf type="diffuse"><rgb name="reflectance" value="0.7"/></bsdf></bsdf><shape type="cube"><ref id="wall" name="bsdf"/></shape>)"},
        {"3.0.0",
         R"(<default name="albedo" value="0.6"/><bsdf type="diffuse" id="m"><rgb name="reflectance" value="$albedo"/></bsdf><shape type="disk"><ref id="m"/><boolean name="flip_normals" value="False"/></shape>)"},
};

}  // namespace

TEST_CASE("kinds of scenes that others write load with nothing replaced or ignored") {
  for (const CensusKind& kind : census_kinds) {
    const bool has_sensor = std::string(kind.body).find("<sensor") != std::string::npos;
    const std::string text = "<scene version=\"" + std::string(kind.version) + "\">\n" + kind.body +
                             (has_sensor ? "" : "\n<sensor type=\"perspective\"/>") + "</scene>";
    INFO(kind.body);
    CHECK(problems(text) == std::vector<std::string>{});
  }
}
