#include "hydraulics/plant/moving_excavator.hpp"

#include "hydraulics/plant/measurement.hpp"
#include "hydraulics/plant/requirement.hpp"
#include "hydraulics/plant/tracking_control.hpp"

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

namespace placedpar::hydraulics {

namespace {

/// The components that the state has for each link. After the components of all links, the state has the pressures at
/// the links' junctions.
enum Part : std::size_t { inlet_psi, piston_in, velocity, inlet_area, bypass_area, outlet_area, parts };
constexpr std::size_t junctions = parts * all_links.size();
using MachineState = std::array<double, junctions + all_links.size()>;

double part(const MachineState& state, std::size_t link, Part which) { return state[link * parts + which]; }
double& part(MachineState& state, std::size_t link, Part which) { return state[link * parts + which]; }
PerLink<double> junctions_psi(const MachineState& state) {
    PerLink<double> psi;
    std::copy_n(state.begin() + junctions, psi.size(), psi.begin());
    return psi;
}

/// The differential equations of a digging excavator during one step. Configuration, commands and loads are constant
/// during the step.
class MovingDynamics {
public:
    explicit MovingDynamics(const MovingExcavator& machine) : machine_(machine) {}

    Configuration configuration = Configuration::a;
    PerLink<OrificeAreas> asked{};
    PerLink<double> load_lbf{};

    ValveFlows flows(const MachineState& state) const {
        ValveLinks links;
        for (std::size_t i = 0; i < all_links.size(); ++i) {
            links.inlet_psi[i] = part(state, i, inlet_psi);
            links.inlet_in2[i] = part(state, i, inlet_area);
            links.bypass_in2[i] = part(state, i, bypass_area);
        }
        return machine_.valve.flows(configuration, junctions_psi(state), links);
    }

    void operator()(const MachineState& state, MachineState& rate, double) const {
        const ValveFlows flow = flows(state);
        for (std::size_t i = 0; i < all_links.size(); ++i) {
            const double drop_psi = part(state, i, inlet_psi) - machine_.valve.flow.tank_psi;
            const double outlet = machine_.valve.one_way(part(state, i, outlet_area), drop_psi);
            link_rate(state, i, flow.inlet[i] - outlet, rate);
        }
        std::ranges::copy(machine_.valve.rates(configuration, flow), rate.begin() + junctions);
    }

private:
    void link_rate(const MachineState& state, std::size_t i, double oil_in3_per_s, MachineState& rate) const {
        const LinkMechanics& link = machine_.links[i];
        const double v = part(state, i, velocity);
        part(rate, i, inlet_psi) = (oil_in3_per_s - link.inlet_area_in2 * v) / link.inlet_compliance_in3_per_psi;
        part(rate, i, piston_in) = v;
        part(rate, i, velocity) =
            (link.inlet_area_in2 * part(state, i, inlet_psi) - load_lbf[i] - link.damping_lbf_s_per_in * v) /
            link.mass_lbf_s2_per_in;
        const double lag = link.spool_lag_per_s;
        part(rate, i, inlet_area) = lag * (asked[i].inlet_in2 - part(state, i, inlet_area));
        part(rate, i, bypass_area) = lag * (asked[i].bypass_in2 - part(state, i, bypass_area));
        part(rate, i, outlet_area) = lag * (asked[i].outlet_in2 - part(state, i, outlet_area));
    }

    const MovingExcavator& machine_;
};

/// A command that waits for the pilot valves' dead time.
struct ValveCommand {
    std::size_t due; ///< the integration step at which the command reaches the valves
    PerLink<OrificeAreas> areas;
};

/// Simulates a digging job in steps of the controller's period.
class Digging {
public:
    Digging(const MovingExcavator& machine, const DigJob& job)
        : machine_(machine), dynamics_(machine), reference_(job, machine.joystick_lag_s),
          start_(*joint_angles(machine.arm, job.start)),
          steps_(steps_in(machine.control_period_s, machine.integration_step_s)),
          late_(static_cast<std::size_t>(std::lround(machine.dead_time_s / machine.integration_step_s))) {
        for (std::size_t i = 0; i < all_links.size(); ++i) {
            const LinkMechanics& link = machine.links[i];
            part(state_, i, inlet_psi) = link.steady_inlet_psi(machine.valve.flow.tank_psi);
            part(state_, i, bypass_area) = machine.bypass_rest_in2;
            state_[junctions + i] = machine.valve.flow.tank_psi;
            dynamics_.asked[i] = {0, machine.bypass_rest_in2, 0};
        }
        set_loads();
    }

    MovingState state(double time_s) const {
        const PerLink<double> psi = junctions_psi(state_);
        MovingState now{time_s,
                        {},
                        psi[index_of(Link::bucket)],
                        psi[index_of(Link::swing)],
                        branch(),
                        dynamics_.configuration,
                        reference_.pose()};
        const ValveFlows flows = dynamics_.flows(state_);
        for (std::size_t i = 0; i < all_links.size(); ++i)
            now.links[i] = {part(state_, i, inlet_psi),
                            angle_rad(i),
                            part(state_, i, velocity) / arm(i),
                            dynamics_.load_lbf[i],
                            {part(state_, i, inlet_area), part(state_, i, bypass_area), part(state_, i, outlet_area)},
                            flows.inlet[i]};
        return now;
    }

    void advance() {
        commands_.push({step_ + late_, controlled()});
        set_loads();
        for (const std::size_t end = step_ + steps_; step_ < end; ++step_) {
            pass_command();
            stepper_.do_step(std::ref(dynamics_), state_, 0.0, machine_.integration_step_s);
            dynamics_.configuration = next_configuration(dynamics_.configuration, branch(), machine_.cross_over);
        }
        reference_.advance(machine_.control_period_s);
    }

private:
    double arm(std::size_t link) const { return machine_.links[link].moment_arm_in; }
    double angle_rad(std::size_t link) const { return start_[link] + part(state_, link, piston_in) / arm(link); }

    /// Passes the oldest command to the pilot valves, if its dead time has ended.
    void pass_command() {
        if (commands_.empty() || commands_.front().due != step_)
            return;
        dynamics_.asked = commands_.front().areas;
        commands_.pop();
    }

    BranchPressures branch() const { return branch_pressures(junctions_psi(state_)); }

    PerLink<OrificeAreas> controlled() const {
        const JointAngles angles = *joint_angles(machine_.arm, reference_.pose());
        PerLink<TrackedLink> now;
        for (std::size_t i = 0; i < all_links.size(); ++i)
            now[i] = {part(state_, i, inlet_psi), angle_rad(i), part(state_, i, velocity) / arm(i)};
        return asked_areas(machine_, dynamics_.configuration, now, angles,
                           joint_rates(machine_.arm, angles, reference_.velocity()));
    }

    /// Sets the load of each link, with the force of the soil against the demanded velocity of the tip. Below 5 in/s
    /// this force is proportional to the velocity.
    void set_loads() {
        constexpr double full_in_per_s = 5;
        const TipPose& v = reference_.velocity();
        const double force =
            reference_.current().soil_lbf / std::max(std::hypot(v.reach_in, v.height_in), full_in_per_s);
        JointAngles angles;
        for (std::size_t i = 0; i < all_links.size(); ++i)
            angles[i] = angle_rad(i);
        const auto torques = joint_torques_lbf_in(machine_.arm, angles, -force * v.reach_in, -force * v.height_in);
        for (Link link : all_links) {
            const std::size_t i = index_of(link);
            dynamics_.load_lbf[i] = machine_.links[i].load_lbf - torques[i] / arm(i);
            if (const std::size_t line = reference_.current().line; !(dynamics_.load_lbf[i] > 0))
                throw UnfitScenario(fmt::format("move {}{}: the soil's force of {:g} lbf cancels the {}'s load of {:g} "
                                                "lbf; the remaining load must be above 0",
                                                reference_.move() + 1, line > 0 ? fmt::format(" (line {})", line) : "",
                                                reference_.current().soil_lbf, name_of(link),
                                                machine_.links[i].load_lbf));
        }
    }

    const MovingExcavator& machine_;
    MovingDynamics dynamics_;
    TipReference reference_;
    JointAngles start_;
    std::size_t steps_, late_; ///< integration steps in a control period, and in the dead time
    std::size_t step_ = 0;     ///< integration steps made
    std::queue<ValveCommand> commands_;
    MachineState state_{};
    boost::numeric::odeint::runge_kutta4<MachineState> stepper_;
};

} // namespace

void simulate_moving(const MovingExcavator& machine, const DigJob& job,
                     const std::function<void(const MovingState&)>& show) {
    if (auto move = unreachable_move(job, machine.arm, machine.joystick_lag_s, machine.control_period_s))
        throw UnfitScenario(fmt::format("move {}: the arm does not reach the tip's path", *move + 1));
    Digging digging(machine, job);
    const auto periods = static_cast<std::size_t>(std::lround(job.duration_s() / machine.control_period_s));
    for (std::size_t i = 0;; ++i) {
        const double time_s = static_cast<double>(i) * machine.control_period_s;
        show(digging.state(time_s));
        if (i == periods)
            return;
        digging.advance();
    }
}

} // namespace placedpar::hydraulics
