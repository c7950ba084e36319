// The checks in turn; one whose renders fail does not stop the others.
#include "differential/examine.h"

#include "differential/check_bytes.h"
#include "differential/check_light.h"

namespace sunfleck::engine::differential {
namespace {

/// Runs a check; what stops its renders is its fault.
template <class Check>
void run_check(Findings& findings, const Check& check) {
    try {
        check();
    } catch (const RenderFault& failed) {
        findings.faults.push_back(failed.fault());
    }
}

}  // namespace

Findings examine(Renders& renders, const Witnesses& witnesses, const Effort& effort) {
    Findings findings;
    run_check(findings, [&] { check_light(renders, witnesses, effort, findings); });
    if (effort.with_bytes)
        run_check(findings, [&] {
            if (auto fault = check_bytes(renders)) findings.faults.push_back(*fault);
        });
    findings.seconds = renders.seconds();
    return findings;
}

bool has_fault(Renders& renders, const Witnesses& witnesses, Kind kind) {
    Findings findings;
    run_check(findings, [&] {
        if (kind == Kind::threads || kind == Kind::resume) {
            if (auto fault = check_bytes(renders)) findings.faults.push_back(*fault);
        } else {
            check_light(renders, witnesses,
                        {.with_discs = kind == Kind::error_bars || kind == Kind::discs,
                         .significance = 1e-3},
                        findings);
        }
    });
    for (const Fault& fault : findings.faults)
        if (fault.kind == kind) return true;
    return false;
}

}  // namespace sunfleck::engine::differential
