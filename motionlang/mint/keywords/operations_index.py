"""In which module of this folder what a verb does stands, and what raises the events of a kind.

Written by `indexing`; do not edit.
"""

from __future__ import annotations

VERBS = {
    "auxiliary_latches_operations": """
auxiliary_latches.setting.trigger_mode auxiliary_latches.setting.input auxiliary_latches.setting.edge
auxiliary_latches.setting.source auxiliary_latches.setting.axis auxiliary_latches.setting.again
auxiliary_latches.setting.inhibit_time auxiliary_latches.setting.inhibit_distance auxiliary_latches.enable
auxiliary_latches.caught auxiliary_latches.encoder auxiliary_latches.passed auxiliary_latches.aux_passed
auxiliary_latches.zero_enable auxiliary_latches.zero_mode auxiliary_latches.zero_place
""",
    "axis_operations": """
default_axes scale accel decel accel_time decel_time profile_mode buffer_size enabled
""",
    "buffer_operations": """
buffer.last_id buffer.status buffer.trigger buffer.dwell buffer.out buffer.out_bit buffer.pulse
""",
    "camboxes_operations": """
camboxes.box camboxes.data
""",
    "captures_operations": """
captures.channel.axis captures.channel.mode captures.channel.parameter captures.trigger.absolute
captures.trigger.channel captures.trigger.mode captures.trigger.source captures.trigger.value captures.name
captures.points captures.spacing captures.before captures.trigger captures.running captures.status
captures.progress captures.point
""",
    "comms_operations": """
comms.modbus_parameter comms.real.comms comms.real.netdata comms.real.dpr comms.whole.comms
comms.whole.netdata comms.whole.dpr
""",
    "compensation_operations": """
compensation.setting compensation.table
""",
    "correction_operations": """
correction.correction correction.time
""",
    "drives_operations": """
drives.setting drives.speed drives.velocity drives.position drives.error
""",
    "encoder_wrap_operations": """
encoder_wrap.demand encoder_wrap.target encoder_wrap.last_target encoder_wrap.datum encoder_wrap.frequency
""",
    "event_flags_operations": """
event_flags.pend event_flags.unpend
""",
    "factory_defaults_operations": """
factory_defaults.defaults
""",
    "feedrate_operations": """
feedrate.parameter max_speed max_accel max_decel feedrate.time_to_most accel_jerk_time decel_jerk_time
feedrate.s_ramp
""",
    "following_auxiliary": """
following.auxiliary.position following.auxiliary.velocity following.auxiliary.speed following.auxiliary.mode
following.auxiliary.setting
""",
    "following_masters": """
following.masters.setting
""",
    "following_operations": """
following.follow following.part following.fly following.offset
""",
    "hold_to_analogue_operations": """
hold_to_analogue.hold hold_to_analogue.setting
""",
    "homing_operations": """
homing.home homing.type homing.setting homing.position homing.status homing.phase
""",
    "identity_operations": """
identity.platform identity.version identity.count identity.local identity.fit identity.fit_axis
identity.nothing_wrong identity.takes_moves identity.date identity.nothing
""",
    "io_inputs": """
io.inputs.bank io.inputs.bit io.inputs.level_bank io.inputs.level_bit io.inputs.active_level
io.inputs.debounce io.inputs.pattern
""",
    "io_outputs": """
io.outputs.bank io.outputs.bit io.outputs.active_level io.outputs.adc io.outputs.adc_setting io.outputs.dac
""",
    "io_signals": """
io.signals.enable_output io.signals.error_output
""",
    "jogging_operations": """
jogging.setting jogging.command jogging.time jogging.velocity
""",
    "latches_operations": """
latches.setting.trigger_mode latches.setting.input latches.setting.edge latches.setting.source
latches.setting.axis latches.setting.again latches.setting.inhibit_time latches.setting.inhibit_distance
latches.enable latches.caught latches.value latches.encoder
""",
    "latches_position_compare": """
latches.position_compare.mode latches.position_compare.output latches.position_compare.position
latches.position_compare.enable latches.position_compare.passed
""",
    "legacy_operations": """
legacy.error legacy.error_line legacy.error_axis legacy.contour
""",
    "limits_operations": """
limits.mode limits.soft limits.forward limits.reverse limits.either limits.error limits.abort limits.line
""",
    "limits_resetting": """
limits.resetting.stop limits.resetting.stop_mode limits.resetting.reset limits.resetting.reset_all
limits.resetting.default limits.resetting.default_all
""",
    "limits_switches": """
limits.switches.input limits.switches.switch limits.switches.home_switch
""",
    "modbus_operations": """
modbus.word modbus.whole modbus.real modbus.own_register modbus.coil
""",
    "monitoring_operations": """
monitoring.limit monitoring.minded monitoring.beyond monitoring.trim monitoring.following_warning
monitoring.warning monitoring.warning_disable monitoring.mask monitoring.code_mask monitoring.asynchronous
monitoring.enable_switch monitoring.drive_error monitoring.drive_fault monitoring.misc monitoring.misc_disable
""",
    "motion_operations": """
load_by load_to go cancel cancel_all
""",
    "network_groups": """
network.groups.own_node network.groups.connection network.groups.connections network.groups.member
network.groups.comms network.groups.info network.groups.master network.groups.is_master
network.groups.is_member
""",
    "network_operations": """
network.event network.event_info network.bus_state network.bus_reset network.scan network.comms_real
network.comms_whole network.first_bus_comms network.encoder network.object_whole network.object_value
network.object_text network.error_register network.status_register network.emergency network.emergency_stop
network.reset network.input_level network.output_level network.process_data network.send_process_data
network.process_data_valid
""",
    "no_effect_operations": """
no_effect.value
""",
    "nonvolatile_operations": """
nonvolatile.word nonvolatile.real
""",
    "on_the_fly_operations": """
on_the_fly.by on_the_fly.to on_the_fly.suspend
""",
    "paths_operations": """
paths.line paths.arc contour_mode blend_mode paths.blend paths.angle
""",
    "presets_operations": """
presets.format presets.entry presets.index presets.setting presets.inputs
""",
    "relays_operations": """
relays.pulse relays.relay relays.bank relays.auxiliary relays.brake relays.brake_status relays.brake_mode
relays.brake_output relays.brake_delay
""",
    "remote_operations": """
remote.bits.inputs remote.bits.outputs remote.bit.inputs remote.bit.outputs remote.percent.analogue_inputs
remote.percent.analogue_outputs remote.live
""",
    "sensing_operations": """
sensing.axis_mode sensing.acceleration sensing.target sensing.last_target sensing.window sensing.settling_time
sensing.seconds sensing.encoder sensing.encoder_speed sensing.encoder_count sensing.encoder_setting
sensing.wrap sensing.turns
""",
    "serial_operations": """
serial.character serial.waiting serial.forget serial.nothing
""",
    "servo_operations": """
servo.gain.proportional servo.gain.integral servo.gain.integral_limit servo.gain.integral_mode
servo.gain.derivative servo.gain.velocity_feedback servo.gain.velocity_ff servo.gain.accel_ff servo.loop_time
servo.fatal_error servo.torque
""",
    "state_operations": """
is_idle position demand
""",
    "steppers_operations": """
steppers.count steppers.speed steppers.setting
""",
    "table_motion_cams": """
table_motion.cams.table table_motion.cams.cam table_motion.cams.index table_motion.cams.segment
table_motion.cams.phase table_motion.cams.phase_status
""",
    "table_motion_splines": """
table_motion.splines.table table_motion.splines.spline table_motion.splines.setting table_motion.splines.index
table_motion.splines.segment
""",
    "tasks_operations": """
task_priority task_quantum task_status task_suspend task_resume timer_event event_active event_pending
event_disable error_code error_line error_string error_data error_present error_read_next error_read_code
error_text error_clear
""",
    "terminal_operations": """
terminal.terminal terminal.key terminal.held_key terminal.clear_screen terminal.locate terminal.line_start
terminal.beep terminal.place terminal.question terminal.answer terminal.printer
""",
    "timing_operations": """
time
""",
    "torque_operations": """
torque.reference torque.setting torque.demand torque.effort torque.current
""",
    "units_operations": """
units.position units.speed units.acceleration
""",
    "unsimulated_operations": """
unsimulated.value unsimulated.motion unsimulated.command unsimulated.jump
""",
}
SOURCES = {
    "comms": "comms_operations",
    "netdata": "comms_operations",
    "terminalreceive": "event_flags_operations",
    "in": "io_inputs",
    "latch": "latches_operations",
    "fastin": "latches_operations",
    "stop": "limits_switches",
    "bus": "remote_operations",
    "serialreceive": "serial_operations",
}
