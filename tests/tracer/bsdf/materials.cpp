#include "tests/tracer/bsdf/materials.h"

namespace rayshoot::tracer_tests {
namespace {

Material of(SurfaceModel model, float roughness = 0) {
    Material material;
    material.model = model;
    material.roughness = roughness;
    material.colour = {0.9f, 0.6f, 0.3f};
    return material;
}

Surface lambert() {
    Material material = of(SurfaceModel::lambert);
    material.colour = vec3(1);
    return {"white lambert", material, false, true};
}

Surface oren_nayar(float sigma) {
    Material material = of(SurfaceModel::oren_nayar, sigma);
    material.colour = vec3(1);
    return {"oren_nayar of sigma " + std::to_string(sigma), material};
}

Surface phong(float exponent) {
    Material material = of(SurfaceModel::phong);
    material.diffuse = 0.4f;
    material.specular = 0.6f;
    material.shininess = exponent;
    return {"phong of exponent " + std::to_string(exponent), material};
}

Surface cook_torrance(float alpha) {
    Material material = of(SurfaceModel::cook_torrance, alpha);
    material.colour = vec3(1);
    material.specular = 1;
    material.refraction_index = 1.5f;
    return {"cook_torrance of alpha " + std::to_string(alpha), material, alpha == 0};
}

Surface conductor(float alpha) {
    Material material = of(SurfaceModel::conductor, alpha);
    material.colour = vec3(1);
    return {"conductor of alpha " + std::to_string(alpha), material, alpha == 0};
}

Surface dielectric(float alpha, float index) {
    Material material = of(SurfaceModel::dielectric, alpha);
    material.colour = vec3(1);
    material.refraction_index = index;
    return {"dielectric of alpha " + std::to_string(alpha) + ", index " + std::to_string(index),
            material, alpha == 0, alpha == 0, index};
}

Surface nff(float specular, float transmittance, float gloss, float index) {
    Material material = of(SurfaceModel::nff);
    material.diffuse = 0.5f;
    material.specular = specular;
    material.transmittance = transmittance;
    material.shininess = 12;
    material.gloss = gloss;
    material.refraction_index = index;
    return {"nff of Ks " + std::to_string(specular) + ", T " + std::to_string(transmittance) +
                ", gloss " + std::to_string(gloss) + ", index " + std::to_string(index),
            material, gloss == 0 && specular + transmittance > 0, false, index};
}

}  // namespace

std::vector<Surface> surfaces() {
    std::vector<Surface> all{lambert(), oren_nayar(0.1f), oren_nayar(0.5f), oren_nayar(1.5f)};
    for (const float exponent : {0.0f, 1.0f, 20.0f, 200.0f}) all.push_back(phong(exponent));
    for (const float alpha : {0.0f, 0.1f, 0.5f, 1.0f}) all.push_back(cook_torrance(alpha));
    for (const float alpha : {0.0f, 0.05f, 0.3f, 1.0f}) all.push_back(conductor(alpha));
    for (const float alpha : {0.0f, 0.1f, 0.5f, 1.0f}) all.push_back(dielectric(alpha, 1.5f));
    all.push_back(dielectric(0.3f, 0.75f));
    all.push_back(nff(0, 0, 0, 1));
    all.push_back(nff(0.3f, 0, 0, 1));
    all.push_back(nff(0.2f, 0.5f, 0, 1.5f));
    all.push_back(nff(0.2f, 0.5f, 30, 1.5f));
    all.push_back(nff(0.2f, 0.5f, 30, 1));
    return all;
}

}  // namespace rayshoot::tracer_tests
