#include "tests/contract/contract.h"
#include "tests/contract/oracle/closed_meshes.h"
#include "tests/contract/oracle/exact.h"

#include <gtest/gtest.h>

#include <algorithm>

/// Structures (and yardsticks) against exact arithmetic that shares no code with them.
namespace rayshoot::contract {
namespace {

constexpr double margin = 1e-4;     // barycentric; rays nearer to an edge are set aside
constexpr double tolerance = 2e-5;  // relative, of t: float arithmetic from a few sizes away
constexpr double most_set_aside = 0.05;

struct Question {
    std::vector<Ray> rays;
    std::vector<ExactAnswer> answers;
};

/// From up to three sizes away through the middle of the mesh or past it, and from inside.
Question questions(const ClosedMesh& mesh, std::size_t count) {
    Random random(0xe8ac7);
    const ExactOracle oracle(mesh.geometry);
    Question question;
    for (std::size_t i = 0; i < count; ++i) {
        Ray ray;
        ray.origin = i % 4 == 0 ? mesh.inside : random.between(2, 6) * random.direction();
        const vec3 target = random.inside(mesh.geometry.bounds());
        ray.direction = target - ray.origin;
        question.rays.push_back(ray);
        question.answers.push_back(oracle.ask(ray, margin));
    }
    return question;
}

std::string disagreement(const Hit& hit, const ExactAnswer& answer) {
    const bool is_hit = hit.primitive != no_primitive;
    if (is_hit != answer.t.has_value()) return is_hit ? "a hit where there is none" : "no hit";
    if (is_hit && std::abs(static_cast<double>(hit.t) - *answer.t) > tolerance * *answer.t)
        return "t is off";
    return {};
}

void expect_agreement(const Accel& accel, const Question& question, const std::string& where) {
    std::vector<Hit> hits(question.rays.size());
    std::vector<std::uint8_t> occluded(question.rays.size());
    const auto session = accel.open(Mode::timing);
    const RayBatch batch{RayKind::secondary, 1, question.rays, {}};
    ASSERT_TRUE(session->closest(batch, hits).empty());
    ASSERT_TRUE(session->occluded(batch, occluded).empty());
    int set_aside = 0, wrong = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const ExactAnswer& answer = question.answers[i];
        if (answer.ambiguous && ++set_aside) continue;
        const std::string what = disagreement(hits[i], answer);
        if ((what.empty() && occluded[i] == answer.t.has_value()) || ++wrong > 5) continue;
        ADD_FAILURE() << where << ": " << what << ", " << printed(question.rays[i]) << " "
                      << printed(hits[i]) << ", exact t " << answer.t.value_or(-1);
    }
    EXPECT_EQ(wrong, 0) << where;
    EXPECT_LT(set_aside, most_set_aside * static_cast<double>(hits.size())) << where;
    testing::Test::RecordProperty("ambiguous", set_aside);
}

class ExactArithmetic : public testing::TestWithParam<Precision> {};

TEST_P(ExactArithmetic, agrees_with_every_configuration_on_closed_meshes) {
    const Catalogue catalogue = built_in_catalogue();
    for (const ClosedMesh& mesh : closed_meshes(GetParam())) {
        const Question question = questions(mesh, 1000);
        for (const StructureEntry& entry : catalogue)
            for (const std::string_view spec : entry.configurations) {
                if (!refusal(catalogue, spec, mesh.geometry).empty()) continue;
                const auto accel = build(catalogue, spec, {mesh.geometry});
                expect_agreement(*accel, question, std::string(spec) + " on " + mesh.name);
            }
    }
}

INSTANTIATE_TEST_SUITE_P(Precisions, ExactArithmetic,
                         testing::Values(Precision::standard, Precision::watertight),
                         [](const auto& precision) {
                             return precision.param == Precision::standard ? "standard"
                                                                           : "watertight";
                         });

/// Checks the oracle itself: a closed mesh is entered as often as it is left.
TEST(ExactOracle, crosses_a_closed_mesh_an_even_number_of_times_from_outside) {
    for (const ClosedMesh& mesh : closed_meshes(Precision::standard)) {
        const Question question = questions(mesh, 400);
        for (std::size_t i = 0; i < question.rays.size(); ++i) {
            if (question.answers[i].ambiguous) continue;
            EXPECT_EQ(question.answers[i].crossings % 2, i % 4 == 0) << mesh.name << ", ray " << i;
        }
    }
}

/// Hits of one ray, counted by asking for the nearest one behind the last.
int hits_in_a_row(Session& session, Ray ray) {
    int count = 0;
    Hit hit;
    do {
        session.closest({RayKind::secondary, 1, {&ray, 1}, {}}, {&hit, 1});
        count += hit.primitive != no_primitive;
        ray.t_min = hit.t;
    } while (hit.primitive != no_primitive);
    return count;
}

TEST(ExactOracle, counts_as_many_crossings_as_a_structure_does) {
    const Catalogue catalogue = built_in_catalogue();
    for (const ClosedMesh& mesh : closed_meshes(Precision::watertight)) {
        const Question question = questions(mesh, 400);
        for (const std::string& spec : exact_configurations(catalogue)) {
            const auto accel = build(catalogue, spec, {mesh.geometry});
            const auto session = accel->open(Mode::timing);
            for (std::size_t i = 0; i < question.rays.size(); ++i) {
                const ExactAnswer& answer = question.answers[i];
                if (answer.ambiguous) continue;
                EXPECT_EQ(hits_in_a_row(*session, question.rays[i]), answer.crossings)
                    << spec << " on " << mesh.name << ", " << printed(question.rays[i]);
            }
        }
    }
}

}  // namespace
}  // namespace rayshoot::contract
