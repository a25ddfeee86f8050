"""The tables of grammars/mint.lark.

Written by `python -m motionlang.lang.parsing.generate`, not by hand.
"""

# ruff: noqa
# mypy: ignore-errors
# fmt: off

from motionlang.lang.parsing.parser import SHIFT, Tables, goto, leaf, move, new
from motionlang.mint.syntax.build import *
from motionlang.mint.syntax.nodes import *


def _none_0(S, M, top, T):
    S = S, M, top
    top = []
    return S, top


def _module_1(S, M, top, T):
    top = module(top)
    return S, top


def _auto_2(S, M, top, T):
    n = new(Auto)
    n.at = top
    top = n
    return S, top


def _name_3(S, M, top, T):
    n = new(Name)
    n.at = top
    n.name = T[top]
    n.args = None
    n.axes = False
    top = n
    return S, top


def _skip_4(S, M, top, T):
    S, _, v0 = S
    top = v0
    return S, top


def _dotted_5(S, M, top, T):
    top = dotted(top, T[top])
    return S, top


def _end_6(S, M, top, T):
    n = new(End)
    n.at = top
    n.name = None if None is None else T[None]
    top = n
    return S, top


def _exit_7(S, M, top, T):
    n = new(Exit)
    n.at = top
    n.kind = '' if None is None else T[None].lower()
    top = n
    return S, top


def _return_8(S, M, top, T):
    n = new(Return)
    n.at = top
    top = n
    return S, top


def _label_before_9(S, M, top, T):
    S, _, v0 = S
    top = label_before(v0, top, T)
    return S, top


def _call_10(S, M, top, T):
    n = new(Call)
    n.at = top.at
    n.target = top
    top = n
    return S, top


def _body_11(S, M, top, T):
    S = S, M, top
    top = body(S)
    return S, top


def _one_12(S, M, top, T):
    top = [top]
    return S, top


def _const_13(S, M, top, T):
    S, _, v0 = S
    top = constants(v0, top)
    return S, top


def _plain_one_14(S, M, top, T):
    top = [declare(top)]
    return S, top


def _dim_15(S, M, top, T):
    S, _, v0 = S
    n = new(Dim)
    n.at = v0
    n.variables = top
    n.nv = None is not None
    top = n
    return S, top


def _end_16(S, M, top, T):
    S, _, v0 = S
    n = new(End)
    n.at = v0
    n.name = None if top is None else T[top]
    top = n
    return S, top


def _exit_17(S, M, top, T):
    S, _, v0 = S
    n = new(Exit)
    n.at = v0
    n.kind = '' if top is None else T[top].lower()
    top = n
    return S, top


def _gosub_18(S, M, top, T):
    S, _, v0 = S
    n = new(Jump)
    n.at = v0
    n.kind = 'gosub'
    n.name = T[top]
    n.unless = None
    top = n
    return S, top


def _goto_19(S, M, top, T):
    S, _, v0 = S
    n = new(Jump)
    n.at = v0
    n.kind = 'goto'
    n.name = T[top]
    n.unless = None
    top = n
    return S, top


def _label_20(S, M, top, T):
    S, _, v0 = S
    n = new(Label)
    n.at = v0
    n.name = T[top]
    top = n
    return S, top


def _character_21(S, M, top, T):
    n = new(Number)
    n.at = top
    n.value = ord(string(T[top]))
    top = n
    return S, top


def _number_22(S, M, top, T):
    n = new(Number)
    n.at = top
    n.value = NUMBERS[T[top]]
    top = n
    return S, top


def _string_23(S, M, top, T):
    n = new(String)
    n.at = top
    n.value = string(T[top])
    top = n
    return S, top


def _input_24(S, M, top, T):
    S, _, v0 = S
    n = new(Input)
    n.at = v0
    n.target = top
    n.prompt = None if None is None else String(None, string(T[None]))
    n.using = None or []
    n.terminal = None
    top = n
    return S, top


def _bare_call_25(S, M, top, T):
    S, _, v0 = S
    n = new(Call)
    n.at = v0
    n.target = Name(v0, T[v0], top)
    top = n
    return S, top


def _pause_26(S, M, top, T):
    S, _, v0 = S
    n = new(Pause)
    n.at = v0
    n.condition = top
    top = n
    return S, top


def _print_27(S, M, top, T):
    S, _, v0 = S
    n = new(Print)
    n.at = v0
    n.items = top if None is None else [*top, None]
    n.terminal = None
    n.word = ''
    n.line = None
    top = n
    return S, top


def _run_28(S, M, top, T):
    S, _, v0 = S
    n = new(Run)
    n.at = v0
    n.name = T[top]
    top = n
    return S, top


def _name_empty_30(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Name)
    n.at = v0
    n.name = T[v0]
    n.args = []
    n.axes = False
    top = n
    return S, top


def _dim_31(S, M, top, T):
    (S, _, v0), _, v1 = S
    n = new(Dim)
    n.at = v0
    n.variables = top
    n.nv = v1 is not None
    top = n
    return S, top


def _gosub_32(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Jump)
    n.at = v0
    n.kind = 'gosub'
    n.name = T[top]
    n.unless = None
    top = n
    return S, top


def _goto_33(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Jump)
    n.at = v0
    n.kind = 'goto'
    n.name = T[top]
    n.unless = None
    top = n
    return S, top


def _complement_34(S, M, top, T):
    S, _, v0 = S
    n = new(Unary)
    n.at = v0
    n.op = '~'
    n.operand = top
    top = n
    return S, top


def _minus_35(S, M, top, T):
    S, _, v0 = S
    n = new(Unary)
    n.at = v0
    n.op = '-'
    n.operand = top
    top = n
    return S, top


def _not_36(S, M, top, T):
    S, _, v0 = S
    n = new(Unary)
    n.at = v0
    n.op = 'Not'
    n.operand = top
    top = n
    return S, top


def _plus_37(S, M, top, T):
    S, _, v0 = S
    n = new(Unary)
    n.at = v0
    n.op = '+'
    n.operand = top
    top = n
    return S, top


def _if_38(S, M, top, T):
    (S, _, v0), _, v1 = S
    top = if_head(If(v0, v1, [], []))
    return S, top


def _line_print_39(S, M, top, T):
    (S, _, v0), _, v1 = S
    top = line_print(v0, T[v0], v1, top)
    return S, top


def _last_item_40(S, M, top, T):
    n = new(PrintItem)
    n.at = top.at
    n.value = top
    n.using = []
    n.separator = ''
    top = n
    return S, top


def _print_41(S, M, top, T):
    (S, _, v0), _, v1 = S
    n = new(Print)
    n.at = v0
    n.items = v1 if top is None else [*v1, top]
    n.terminal = None
    n.word = ''
    n.line = None
    top = n
    return S, top


def _none_42(S, M, top, T):
    top = []
    return S, top


def _for_43(S, M, top, T):
    (S, _, v0), _, v1 = S
    top = counted(v0, v1, None, T)
    return S, top


def _for_shared_44(S, M, top, T):
    (S, _, v0), _, v1 = S
    top = counted(v0, v1, top, T)
    return S, top


def _if_end_45(S, M, top, T):
    (S, _, v0), _, v1 = S
    top = if_end(v0, v1, [])
    return S, top


def _member_46(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Member)
    n.at = v0.at
    n.value = v0
    n.field = T[top]
    n.args = None
    top = n
    return S, top


def _next_case_47(S, M, top, T):
    (S, _, v0), _, v1 = S
    top = next_case(v0, v1, top)
    return S, top


def _one_omitted_48(S, M, top, T):
    top = [Omitted(top)]
    return S, top


def _assign_50(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Assign)
    n.at = v0.at
    n.target = v0
    n.values = top
    n.repeat = None is not None
    top = n
    return S, top


def _name_args_52(S, M, top, T):
    ((S, _, v0), _, _), _, v2 = S
    n = new(Name)
    n.at = v0
    n.name = T[v0]
    n.args = v2
    n.axes = False
    top = n
    return S, top


def _name_axes_53(S, M, top, T):
    ((S, _, v0), _, _), _, v2 = S
    n = new(Name)
    n.at = v0
    n.name = T[v0]
    n.args = v2
    n.axes = True
    top = n
    return S, top


def _type_54(S, M, top, T):
    n = new(TypeName)
    n.at = top
    n.name = T[top]
    n.size = None
    top = n
    return S, top


def _constant_55(S, M, top, T):
    (S, _, v0), _, _ = S
    top = Const(v0, T[v0], None, top)
    return S, top


def _more_56(S, M, top, T):
    (S, _, v0), _, _ = S
    v0.append(top)
    top = v0
    return S, top


def _define_57(S, M, top, T):
    ((S, _, v0), _, v1), _, _ = S
    n = new(Define)
    n.at = v0
    n.name = T[v1]
    n.value = top
    top = n
    return S, top


def _plain_more_58(S, M, top, T):
    (S, _, v0), _, _ = S
    v0.append(declare(top))
    top = v0
    return S, top


def _variable_59(S, M, top, T):
    (S, _, v0), _, _ = S
    top = declare(v0, top)
    return S, top


def _valued_variable_60(S, M, top, T):
    (S, _, v0), _, _ = S
    top = declare(v0, None, top)
    return S, top


def _more_values_61(S, M, top, T):
    (S, _, v0), _, _ = S
    top = more_values(v0, top)
    return S, top


def _parameter_62(S, M, top, T):
    n = new(Parameter)
    n.at = top
    n.name = T[top]
    n.type = None
    n.by_ref = False
    n.is_array = None is not None
    top = n
    return S, top


def _none_63(S, M, top, T):
    S, _, _ = S
    top = []
    return S, top


def _and_65(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Binary)
    n.at = v0.at
    n.op = 'And'
    n.left = v0
    n.right = top
    top = n
    return S, top


def _if_67(S, M, top, T):
    ((S, _, v0), _, v1), _, _ = S
    top = if_head(If(v0, v1, [], []))
    return S, top


def _line_if_68(S, M, top, T):
    ((S, _, v0), _, v1), _, _ = S
    n = new(If)
    n.at = v0
    n.condition = v1
    n.body = top
    n.orelse = []
    top = n
    return S, top


def _or_69(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Binary)
    n.at = v0.at
    n.op = 'Or'
    n.left = v0
    n.right = top
    top = n
    return S, top


def _xor_70(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Binary)
    n.at = v0.at
    n.op = 'Xor'
    n.left = v0
    n.right = top
    top = n
    return S, top


def _mod_71(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Binary)
    n.at = v0.at
    n.op = 'Mod'
    n.left = v0
    n.right = top
    top = n
    return S, top


def _input_72(S, M, top, T):
    ((S, _, v0), _, v1), _, _ = S
    n = new(Input)
    n.at = v0
    n.target = top
    n.prompt = None if v1 is None else String(v1, string(T[v1]))
    n.using = None or []
    n.terminal = None
    top = n
    return S, top


def _input_73(S, M, top, T):
    ((S, _, v0), _, v1), _, _ = S
    n = new(Input)
    n.at = v0
    n.target = v1
    n.prompt = None if None is None else String(None, string(T[None]))
    n.using = top or []
    n.terminal = None
    top = n
    return S, top


def _loop_74(S, M, top, T):
    ((S, _, v0), _, _), _, v2 = S
    n = new(Loop)
    n.at = v0
    n.body = v2
    top = n
    return S, top


def _rest_75(S, M, top, T):
    S, _, v0 = S
    top = printed(top, None, [], T[v0])
    return S, top


def _rest_last_76(S, M, top, T):
    S, _, _ = S
    top = printed([], None, top, "")
    return S, top


def _print_item_77(S, M, top, T):
    (S, _, v0), _, v1 = S
    n = new(PrintItem)
    n.at = v1.at
    n.value = v1
    n.using = []
    n.separator = T[top]
    v0.append(n)
    top = v0
    return S, top


def _for_78(S, M, top, T):
    ((S, _, v0), _, v1), _, _ = S
    top = counted(v0, v1, top, T)
    return S, top


def _test_79(S, M, top, T):
    n = new(CaseTest)
    n.at = top.at
    n.op = '='
    n.value = top
    n.high = None
    top = n
    return S, top


def _last_case_80(S, M, top, T):
    ((S, _, v0), _, v1), _, _ = S
    top = last_case(v0, v1)
    return S, top


def _one_81(S, M, top, T):
    S, _, v0 = S
    top = [v0]
    return S, top


def _assign_same_82(S, M, top, T):
    ((S, _, v0), _, _), _, v2 = S
    n = new(Assign)
    n.at = v0.at
    n.target = v0
    n.values = [v2]
    n.repeat = True
    top = n
    return S, top


def _next_omitted_83(S, M, top, T):
    S, _, v0 = S
    n = new(Omitted)
    n.at = top
    v0.append(n)
    top = v0
    return S, top


def _last_84(S, M, top, T):
    S, _, v0 = S
    v0.append(top)
    top = v0
    return S, top


def _assign_85(S, M, top, T):
    ((S, _, v0), _, _), _, v2 = S
    n = new(Assign)
    n.at = v0.at
    n.target = v0
    n.values = v2
    n.repeat = top is not None
    top = n
    return S, top


def _pair_86(S, M, top, T):
    (S, _, v0), _, _ = S
    top = [v0, top]
    return S, top


def _parameter_by_reference_87(S, M, top, T):
    S, _, v0 = S
    n = new(Parameter)
    n.at = v0
    n.name = T[top]
    n.type = None
    n.by_ref = True
    n.is_array = None is not None
    top = n
    return S, top


def _parameter_by_value_88(S, M, top, T):
    S, _, v0 = S
    n = new(Parameter)
    n.at = v0
    n.name = T[top]
    n.type = None
    n.by_ref = False
    n.is_array = None is not None
    top = n
    return S, top


def _input_89(S, M, top, T):
    (((S, _, v0), _, _), _, v2), _, _ = S
    n = new(Input)
    n.at = v0
    n.target = top
    n.prompt = None if None is None else String(None, string(T[None]))
    n.using = None or []
    n.terminal = v2
    top = n
    return S, top


def _rest_90(S, M, top, T):
    (S, _, v0), _, v1 = S
    top = printed(v1, top, [], T[v0])
    return S, top


def _print_91(S, M, top, T):
    (((S, _, v0), _, _), _, v2), _, _ = S
    n = new(Print)
    n.at = v0
    n.items = top if None is None else [*top, None]
    n.terminal = v2
    n.word = ''
    n.line = None
    top = n
    return S, top


def _last_using_92(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(PrintItem)
    n.at = v0.at
    n.value = v0
    n.using = top
    n.separator = ''
    top = n
    return S, top


def _repeat_93(S, M, top, T):
    (((S, _, v0), _, _), _, v2), _, _ = S
    n = new(Repeat)
    n.at = v0
    n.body = v2
    n.condition = top
    top = n
    return S, top


def _select_94(S, M, top, T):
    (((S, _, v0), _, _), _, v2), _, _ = S
    n = new(Select)
    n.at = v0
    n.subject = v2
    n.cases = [top]
    top = n
    return S, top


def _startup_95(S, M, top, T):
    (((S, _, v0), _, _), _, v2), _, _ = S
    n = new(Startup)
    n.at = v0
    n.body = v2
    top = n
    return S, top


def _while_96(S, M, top, T):
    (((S, _, v0), _, v1), _, _), _, v3 = S
    n = new(While)
    n.at = v0
    n.condition = v1
    n.body = v3
    top = n
    return S, top


def _else_if_97(S, M, top, T):
    (((S, _, v0), _, v1), _, v2), _, v3 = S
    top = else_if(v0, v1, If(v2, v3, [], []))
    return S, top


def _case_else_98(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Case)
    n.at = v0
    n.tests = []
    n.body = []
    top = n
    return S, top


def _case_99(S, M, top, T):
    (S, _, v0), _, v1 = S
    n = new(Case)
    n.at = v0
    n.tests = v1
    n.body = []
    top = n
    return S, top


def _sized_type_100(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(TypeName)
    n.at = v0
    n.name = T[v0]
    n.size = top
    top = n
    return S, top


def _constant_101(S, M, top, T):
    (((S, _, v0), _, _), _, v2), _, _ = S
    top = Const(v0, T[v0], v2, top)
    return S, top


def _typed_variable_102(S, M, top, T):
    (((S, _, v0), _, _), _, v2), _, _ = S
    top = declare(v0, v2, top)
    return S, top


def _event_103(S, M, top, T):
    ((((S, _, v0), _, v1), _, _), _, v3), _, _ = S
    n = new(Event)
    n.at = v0
    n.name = T[v1]
    n.body = v3
    top = n
    return S, top


def _parameter_104(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v0]
    n.type = top
    n.by_ref = False
    n.is_array = None is not None
    top = n
    return S, top


def _parameter_105(S, M, top, T):
    (S, _, v0), _, v1 = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v0]
    n.type = None
    n.by_ref = False
    n.is_array = v1 is not None
    top = n
    return S, top


def _line_if_else_106(S, M, top, T):
    ((((S, _, v0), _, v1), _, _), _, v3), _, _ = S
    n = new(If)
    n.at = v0
    n.condition = v1
    n.body = v3
    n.orelse = top
    top = n
    return S, top


def _input_107(S, M, top, T):
    ((((S, _, v0), _, v1), _, _), _, v3), _, _ = S
    n = new(Input)
    n.at = v0
    n.target = v3
    n.prompt = None if v1 is None else String(v1, string(T[v1]))
    n.using = top or []
    n.terminal = None
    top = n
    return S, top


def _rest_using_108(S, M, top, T):
    ((S, _, _), _, v1), _, v2 = S
    top = printed(top, None, [v1], T[v2])
    return S, top


def _print_109(S, M, top, T):
    ((((S, _, v0), _, _), _, v2), _, _), _, v4 = S
    n = new(Print)
    n.at = v0
    n.items = v4 if top is None else [*v4, top]
    n.terminal = v2
    n.word = ''
    n.line = None
    top = n
    return S, top


def _last_open_110(S, M, top, T):
    ((S, _, v0), _, _), _, v2 = S
    n = new(PrintItem)
    n.at = v0.at
    n.value = v0
    n.using = [v2]
    n.separator = ','
    top = n
    return S, top


def _print_using_111(S, M, top, T):
    (((S, _, v0), _, v1), _, _), _, v3 = S
    n = new(PrintItem)
    n.at = v1.at
    n.value = v1
    n.using = [v3]
    n.separator = T[top]
    v0.append(n)
    top = v0
    return S, top


def _select_nothing_112(S, M, top, T):
    ((((S, _, v0), _, _), _, v2), _, _), _, _ = S
    n = new(Select)
    n.at = v0
    n.subject = v2
    n.cases = []
    top = n
    return S, top


def _task_113(S, M, top, T):
    ((((S, _, v0), _, v1), _, _), _, v3), _, _ = S
    top = task(v0, T[v1], v3)
    return S, top


def _user_type_114(S, M, top, T):
    ((((S, _, v0), _, v1), _, _), _, v3), _, _ = S
    n = new(UserType)
    n.at = v0
    n.name = T[v1]
    n.members = v3
    top = n
    return S, top


def _extend_115(S, M, top, T):
    (S, _, v0), _, v1 = S
    top = extended(v0, v1)
    return S, top


def _shared_further_116(S, M, top, T):
    (((S, _, v0), _, v1), _, v2), _, v3 = S
    v0.append(counted(v1, v2, v3, T))
    top = v0
    return S, top


def _if_else_117(S, M, top, T):
    ((((S, _, v0), _, v1), _, _), _, _), _, v4 = S
    top = if_end(v0, v1, v4)
    return S, top


def _member_args_118(S, M, top, T):
    ((((S, _, v0), _, _), _, v2), _, _), _, v4 = S
    n = new(Member)
    n.at = v0.at
    n.value = v0
    n.field = T[v2]
    n.args = v4
    top = n
    return S, top


def _test_is_119(S, M, top, T):
    (S, _, v0), _, v1 = S
    n = new(CaseTest)
    n.at = v0
    n.op = T[v1]
    n.value = top
    n.high = None
    top = n
    return S, top


def _test_range_120(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(CaseTest)
    n.at = v0.at
    n.op = 'To'
    n.value = v0
    n.high = top
    top = n
    return S, top


def _for_head_121(S, M, top, T):
    (((((S, _, v0), _, v1), _, _), _, v3), _, _), _, v5 = S
    n = new(For)
    n.at = v0
    n.variable = Name(v1, T[v1])
    n.start = v3
    n.stop = v5
    n.step = None
    n.body = []
    top = n
    return S, top


def _parameter_by_reference_122(S, M, top, T):
    ((S, _, v0), _, v1), _, _ = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = top
    n.by_ref = True
    n.is_array = None is not None
    top = n
    return S, top


def _parameter_by_reference_123(S, M, top, T):
    ((S, _, v0), _, v1), _, v2 = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = None
    n.by_ref = True
    n.is_array = v2 is not None
    top = n
    return S, top


def _parameter_by_value_124(S, M, top, T):
    ((S, _, v0), _, v1), _, _ = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = top
    n.by_ref = False
    n.is_array = None is not None
    top = n
    return S, top


def _parameter_by_value_125(S, M, top, T):
    ((S, _, v0), _, v1), _, v2 = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = None
    n.by_ref = False
    n.is_array = v2 is not None
    top = n
    return S, top


def _function_126(S, M, top, T):
    (((((S, _, v0), _, v1), _, v2), _, _), _, v4), _, _ = S
    n = new(Sub)
    n.at = v0
    n.name = T[v1]
    n.parameters = v2
    n.body = v4
    n.function = True
    n.result = None
    top = n
    return S, top


def _input_127(S, M, top, T):
    (((((S, _, v0), _, _), _, v2), _, _), _, v4), _, _ = S
    n = new(Input)
    n.at = v0
    n.target = top
    n.prompt = None if v4 is None else String(v4, string(T[v4]))
    n.using = None or []
    n.terminal = v2
    top = n
    return S, top


def _input_128(S, M, top, T):
    (((((S, _, v0), _, _), _, v2), _, _), _, v4), _, _ = S
    n = new(Input)
    n.at = v0
    n.target = v4
    n.prompt = None if None is None else String(None, string(T[None]))
    n.using = top or []
    n.terminal = v2
    top = n
    return S, top


def _rest_using_129(S, M, top, T):
    (((S, _, _), _, v1), _, v2), _, v3 = S
    top = printed(v3, top, [v1], T[v2])
    return S, top


def _sub_130(S, M, top, T):
    (((((S, _, v0), _, v1), _, v2), _, _), _, v4), _, _ = S
    n = new(Sub)
    n.at = v0
    n.name = T[v1]
    n.parameters = v2
    n.body = v4
    n.function = False
    n.result = None
    top = n
    return S, top


def _extend_131(S, M, top, T):
    ((S, _, v0), _, _), _, v2 = S
    top = extended(v0, v2)
    return S, top


def _shared_132(S, M, top, T):
    ((((S, _, v0), _, v1), _, v2), _, _), _, v4 = S
    v0.append(counted(v1, v2, v4, T))
    top = v0
    return S, top


def _parameter_133(S, M, top, T):
    (((S, _, v0), _, v1), _, _), _, _ = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v0]
    n.type = top
    n.by_ref = False
    n.is_array = v1 is not None
    top = n
    return S, top


def _rest_using_two_134(S, M, top, T):
    ((((S, _, _), _, v1), _, _), _, v3), _, v4 = S
    top = printed(top, None, [v1, v3], T[v4])
    return S, top


def _print_using_two_135(S, M, top, T):
    (((((S, _, v0), _, v1), _, _), _, v3), _, _), _, v5 = S
    n = new(PrintItem)
    n.at = v1.at
    n.value = v1
    n.using = [v3, v5]
    n.separator = T[top]
    v0.append(n)
    top = v0
    return S, top


def _for_head_136(S, M, top, T):
    (((((((S, _, v0), _, v1), _, _), _, v3), _, _), _, v5), _, _), _, v7 = S
    n = new(For)
    n.at = v0
    n.variable = Name(v1, T[v1])
    n.start = v3
    n.stop = v5
    n.step = v7
    n.body = []
    top = n
    return S, top


def _parameter_by_reference_137(S, M, top, T):
    ((((S, _, v0), _, v1), _, v2), _, _), _, _ = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = top
    n.by_ref = True
    n.is_array = v2 is not None
    top = n
    return S, top


def _parameter_by_value_138(S, M, top, T):
    ((((S, _, v0), _, v1), _, v2), _, _), _, _ = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = top
    n.by_ref = False
    n.is_array = v2 is not None
    top = n
    return S, top


def _function_139(S, M, top, T):
    (((((((S, _, v0), _, v1), _, v2), _, _), _, v4), _, _), _, v6), _, _ = S
    n = new(Sub)
    n.at = v0
    n.name = T[v1]
    n.parameters = v2
    n.body = v6
    n.function = True
    n.result = v4
    top = n
    return S, top


def _input_140(S, M, top, T):
    (((((((S, _, v0), _, _), _, v2), _, _), _, v4), _, _), _, v6), _, _ = S
    n = new(Input)
    n.at = v0
    n.target = v6
    n.prompt = None if v4 is None else String(v4, string(T[v4]))
    n.using = top or []
    n.terminal = v2
    top = n
    return S, top


def _rest_using_two_141(S, M, top, T):
    (((((S, _, _), _, v1), _, _), _, v3), _, v4), _, v5 = S
    top = printed(v5, top, [v1, v3], T[v4])
    return S, top



def _run(moves, kinds, T):
    following = iter(kinds)
    code, target = move(moves, next(following))
    S = top = None
    for at, kind in enumerate(following):
        while True:
            if code < 0:
                break
            elif code == 0:
                (S, _, v0), _, v1 = S
                n = new(Binary)
                n.at = v0.at
                n.op = T[v1]
                n.left = v0
                n.right = top
                top = n
            elif code == 1:
                (S, _, v0), _, v1 = S
                v0.append(v1)
                top = v0
            elif code == 2:
                (S, _, v0), _, _ = S
                n = new(Assign)
                n.at = v0.at
                n.target = v0
                n.values = [top]
                n.repeat = False
                top = n
            elif code == 3:
                ((S, _, v0), _, _), _, v2 = S
                n = new(Name)
                n.at = v0
                n.name = T[v0]
                n.args = [v2]
                n.axes = False
                top = n
            elif code == 4:
                (S, _, _), _, v1 = S
                top = v1
            else:
                reducer, target = target
                S, top = reducer(S, moves, top, T)
            try:
                moves, code, target = S[1][target]
            except KeyError:
                moves, code, target = goto(S[1], target)
        S = S, moves, top
        if code == -1:
            top, moves = at, target
            try:
                code, target = moves[kind]
            except KeyError:
                code, target = move(moves, kind)
        else:
            try:
                made, moves, code, target = target[kind]
            except KeyError:
                made, moves, code, target = leaf(target, kind)
            if made == 1:
                n = new(Number)
                n.at = at
                n.value = NUMBERS[T[at]]
                top = n
            elif made == 2:
                n = new(Name)
                n.at = at
                n.name = T[at]
                n.args = None
                n.axes = False
                top = n
            else:
                top = at
    return S[2]


TOKEN = '[ \t]*+([!\\#%\\&\\(\\)\\*\\+,\\-/;=\\?\\[\\\\\\]\\^\\|\\~]|[A-Za-z_](?!(?<=[Rr])(?:[Ee][Mm]\\b|(?<=R)EM[A-Z][a-z]))[A-Za-z0-9_]*+(?!\\.[0-9])|[0-9.](?:(?<=[0-9])[0-9]*+\\.?[0-9]*+(?:[eE][+-]?[0-9]++)?|(?<=\\.)[0-9]++(?:[eE][+-]?[0-9]++)?|(?<=0)(?:[xX][0-9a-fA-F]++|[bB][01]++))(?![A-Za-z0-9_])|[\n\':Rr](?:(?<=\n)|(?<=\')[^\n]*+\n|(?:(?<=:)[ \t]*+[Rr])?(?<=[Rr])(?:[Ee][Mm]\\b|(?<=R)EM(?=[A-Z][a-z]))[^\n]*+\n)[ \t]*+(?>(?:(?:\'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)*)|"[^"\\\\\n]*+(?>(?:\\\\[^\n][^"\\\\\n]*+)*)"|[A-Za-z_][A-Za-z0-9_]*+(?>(?:\\.[0-9]++)+)|`(?:[^`\\\\\n]|\\\\[^\n])`|<<|<=|<>|>=|>>|"[^\\n]*|[0-9][A-Za-z0-9_]*|.)'

CONTINUED = '(?:[ \t]++|[\\\\_][ \t]*+(?:\'[^\n]*+)?\n)*([!\\#%\\&\\(\\)\\*\\+,\\-/;=\\?\\[\\\\\\]\\^\\|\\~]|[A-Za-z_](?!(?<=[Rr])(?:[Ee][Mm]\\b|(?<=R)EM[A-Z][a-z]))[A-Za-z0-9_]*+(?!\\.[0-9])|[0-9.](?:(?<=[0-9])[0-9]*+\\.?[0-9]*+(?:[eE][+-]?[0-9]++)?|(?<=\\.)[0-9]++(?:[eE][+-]?[0-9]++)?|(?<=0)(?:[xX][0-9a-fA-F]++|[bB][01]++))(?![A-Za-z0-9_])|[\n\':Rr](?:(?<=\n)|(?<=\')[^\n]*+\n|(?:(?<=:)[ \t]*+[Rr])?(?<=[Rr])(?:[Ee][Mm]\\b|(?<=R)EM(?=[A-Z][a-z]))[^\n]*+\n)[ \t]*+(?>(?:(?:\'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)*)|"[^"\\\\\n]*+(?>(?:\\\\[^\n][^"\\\\\n]*+)*)"|[A-Za-z_][A-Za-z0-9_]*+(?>(?:\\.[0-9]++)+)|`(?:[^`\\\\\n]|\\\\[^\n])`|<<|<=|<>|>=|>>|"[^\\n]*|[0-9][A-Za-z0-9_]*|.)'

LITERALS = {
    '!': 'COMPLEMENT',
    '#': 'HASH',
    '%': 'PERCENT',
    '&': 'AMPERSAND',
    '(': 'LPAR',
    ')': 'RPAR',
    '*': 'STAR',
    '+': 'PLUS',
    ',': 'COMMA',
    '-': 'MINUS',
    '.': 'DOT',
    '/': 'DIVIDE',
    ':': 'COLON',
    ';': 'SEMICOLON',
    '<': 'COMPARE',
    '<<': 'SHIFT',
    '<=': 'COMPARE',
    '<>': 'COMPARE',
    '=': 'EQUAL',
    '>': 'COMPARE',
    '>=': 'COMPARE',
    '>>': 'SHIFT',
    '?': 'QMARK',
    '[': 'LSQB',
    '\\': 'DIVIDE',
    ']': 'RSQB',
    '^': 'CIRCUMFLEX',
    'and': 'AND',
    'as': 'AS',
    'auto': 'AUTO',
    'byref': 'BYREF',
    'byval': 'BYVAL',
    'case': 'CASE',
    'const': 'CONST',
    'define': 'DEFINE',
    'dim': 'DIM',
    'do': 'DO',
    'else': 'ELSE',
    'elseif': 'ELSEIF',
    'end': 'END',
    'endif': 'ENDIF',
    'endl': 'ENDL',
    'endloop': 'ENDLOOP',
    'endw': 'ENDW',
    'endwhile': 'ENDWHILE',
    'event': 'EVENT',
    'exit': 'EXIT',
    'for': 'FOR',
    'function': 'FUNCTION',
    'gosub': 'GOSUB',
    'goto': 'GOTO',
    'if': 'IF',
    'input': 'INPUT',
    'is': 'IS',
    'loop': 'LOOP',
    'mod': 'MOD',
    'next': 'NEXT',
    'not': 'NOT',
    'nv': 'NV',
    'or': 'OR',
    'pause': 'PAUSE',
    'print': 'PRINT',
    'repeat': 'REPEAT',
    'return': 'RETURN',
    'run': 'RUN',
    'select': 'SELECT',
    'startup': 'STARTUP',
    'step': 'STEP',
    'sub': 'SUB',
    'task': 'TASK',
    'then': 'THEN',
    'to': 'TO',
    'type': 'TYPE',
    'until': 'UNTIL',
    'using': 'USING',
    'wend': 'WEND',
    'while': 'WHILE',
    'xor': 'XOR',
    '|': 'VBAR',
    '~': 'COMPLEMENT',
}

CLASSES = {
    'NAME': '[A-Za-z_](?!(?<=[Rr])(?:[Ee][Mm]\\b|(?<=R)EM[A-Z][a-z]))[A-Za-z0-9_]*+(?!\\.[0-9])',
    'NUMBER': '[0-9.](?:(?<=[0-9])[0-9]*+\\.?[0-9]*+(?:[eE][+-]?[0-9]++)?|(?<=\\.)[0-9]++(?:[eE][+-]?[0-9]++)?|(?<=0)(?:[xX][0-9a-fA-F]++|[bB][01]++))(?![A-Za-z0-9_])',
    '_NL': "[\n':Rr](?:(?<=\n)|(?<=')[^\n]*+\n|(?:(?<=:)[ \t]*+[Rr])?(?<=[Rr])(?:[Ee][Mm]\\b|(?<=R)EM(?=[A-Z][a-z]))[^\n]*+\n)[ \t]*+(?>(?:(?:'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)*)",
    'STRING': '"[^"\\\\\n]*+(?>(?:\\\\[^\n][^"\\\\\n]*+)*)"',
    'DOTTED': '[A-Za-z_][A-Za-z0-9_]*+(?>(?:\\.[0-9]++)+)',
    'CHARACTER': '`(?:[^`\\\\\n]|\\\\[^\n])`',
}

SPELLINGS = {
    'MOD': 'Mod',
    'AND': 'And',
    'AS': 'As',
    'AUTO': 'Auto',
    'BYREF': 'ByRef',
    'BYVAL': 'ByVal',
    'CASE': 'Case',
    'CONST': 'Const',
    'DEFINE': 'Define',
    'DIM': 'Dim',
    'DO': 'Do',
    'ELSE': 'Else',
    'ELSEIF': 'ElseIf',
    'END': 'End',
    'ENDIF': 'EndIf',
    'ENDL': 'EndL',
    'ENDLOOP': 'EndLoop',
    'ENDW': 'EndW',
    'ENDWHILE': 'EndWhile',
    'EVENT': 'Event',
    'EXIT': 'Exit',
    'FOR': 'For',
    'FUNCTION': 'Function',
    'GOSUB': 'GoSub',
    'GOTO': 'GoTo',
    'IF': 'If',
    'INPUT': 'Input',
    'IS': 'Is',
    'LOOP': 'Loop',
    'NEXT': 'Next',
    'NOT': 'Not',
    'NV': 'NV',
    'OR': 'Or',
    'PAUSE': 'Pause',
    'PRINT': 'Print',
    'REPEAT': 'Repeat',
    'RETURN': 'Return',
    'RUN': 'Run',
    'SELECT': 'Select',
    'STARTUP': 'Startup',
    'STEP': 'Step',
    'SUB': 'Sub',
    'TASK': 'Task',
    'THEN': 'Then',
    'TO': 'To',
    'TYPE': 'Type',
    'UNTIL': 'Until',
    'USING': 'Using',
    'WEND': 'Wend',
    'WHILE': 'While',
    'XOR': 'Xor',
    'COLON': ':',
    'LPAR': '(',
    'RPAR': ')',
    'COMMA': ',',
    'STAR': '*',
    'SEMICOLON': ';',
    'HASH': '#',
    'EQUAL': '=',
    'QMARK': '?',
    'MINUS': '-',
    'PLUS': '+',
    'VBAR': '|',
    'LSQB': '[',
    'RSQB': ']',
    'DOT': '.',
    'AMPERSAND': '&',
    'PERCENT': '%',
    'CIRCUMFLEX': '^',
}

RULES = (
    (0, 'items', _none_0),
    (1, 'start', _module_1),
    (1, 'inline_statement', _auto_2),
    (1, 'leading', None),
    (1, 'name{leading}', _name_3),
    (2, 'items', _skip_4),
    (1, 'axes', _dotted_5),
    (1, 'inline_statement', _end_6),
    (1, 'leading', None),
    (1, 'inline_statement', _exit_7),
    (1, 'leading', None),
    (1, 'name{NAME}', _name_3),
    (0, 'print_list', _none_0),
    (1, 'inline_statement', _return_8),
    (1, 'leading', None),
    (1, 'leading', None),
    (1, 'leading', None),
    (1, 'leading', None),
    (2, 'items', _label_before_9),
    (1, 'target', None),
    (1, 'call', None),
    (1, 'inline_statement', _call_10),
    (0, 'body', _body_11),
    (1, 'ref{name{NAME}}', None),
    (1, 'call', None),
    (1, 'target', None),
    (1, 'target', None),
    (1, 'constants', _one_12),
    (2, 'inline_statement', _const_13),
    (1, 'declared', _name_3),
    (1, 'leading', None),
    (1, 'dims', None),
    (1, 'closed_dims', _plain_one_14),
    (2, 'inline_statement', _dim_15),
    (1, 'dims', None),
    (1, 'closed_dims', _one_12),
    (1, 'open_dims', _one_12),
    (2, 'inline_statement', _end_16),
    (2, 'inline_statement', _exit_17),
    (0, 'parameters', _none_0),
    (2, 'inline_statement', _gosub_18),
    (2, 'inline_statement', _goto_19),
    (2, 'inline_statement', _label_20),
    (1, 'name{word}', _name_3),
    (1, 'operand', _character_21),
    (1, 'operand', _number_22),
    (1, 'operand', _string_23),
    (1, 'or{atom}', None),
    (1, 'term{atom}', None),
    (1, 'bit_or{atom}', None),
    (1, 'compare{atom}', None),
    (1, 'not{atom}', None),
    (1, 'variable', None),
    (1, 'expr', None),
    (1, 'bit_and{atom}', None),
    (1, 'shift{atom}', None),
    (1, 'sum{atom}', None),
    (2, 'inline_statement', _input_24),
    (1, 'or{operand}', None),
    (1, 'term{operand}', None),
    (2, 'inline_statement', _bare_call_25),
    (1, 'bit_or{operand}', None),
    (1, 'compare{operand}', None),
    (1, 'not{operand}', None),
    (1, 'bare', _one_12),
    (1, 'bit_and{operand}', None),
    (1, 'shift{operand}', None),
    (1, 'sum{operand}', None),
    (2, 'inline_statement', _pause_26),
    (2, 'inline_statement', _print_27),
    (2, 'inline_statement', _run_28),
    (3, 'items', 1),
    (3, 'items', 1),
    (3, 'items', 1),
    (3, 'items', 1),
    (3, 'items', 1),
    (3, 'name{leading}', _name_empty_30),
    (1, 'exprs', _one_12),
    (3, 'inline_statement', _dim_31),
    (3, 'inline_statement', _gosub_32),
    (3, 'inline_statement', _goto_33),
    (2, 'unary{atom}', _complement_34),
    (2, 'unary{atom}', _minus_35),
    (2, 'negated', _not_36),
    (2, 'unary{atom}', _plus_37),
    (3, 'if_head', _if_38),
    (1, 'line_then', None),
    (2, 'unary{operand}', _complement_34),
    (3, 'name{NAME}', _name_empty_30),
    (2, 'unary{operand}', _minus_35),
    (2, 'unary{operand}', _plus_37),
    (3, 'inline_statement', _line_print_39),
    (1, 'print_last', _last_item_40),
    (3, 'inline_statement', _print_41),
    (0, 'task_body', _body_11),
    (1, 'seps', _none_42),
    (0, 'members', _none_0),
    (2, 'body', _skip_4),
    (3, 'inline_statement', _for_43),
    (2, 'body', _label_before_9),
    (3, 'inline_statement', _for_shared_44),
    (1, 'end_if', None),
    (3, 'statement', _if_end_45),
    (3, 'ref{name{leading}}', _member_46),
    (3, 'ref{name{NAME}}', _member_46),
    (3, 'select_head', _next_case_47),
    (1, 'slots', _one_omitted_48),
    (3, 'inline_statement', 2),
    (3, 'inline_statement', _assign_50),
    (4, 'name{leading}', 3),
    (4, 'name{leading}', _name_args_52),
    (4, 'name{leading}', _name_axes_53),
    (1, 'type', _type_54),
    (3, 'constant', _constant_55),
    (3, 'constants', _more_56),
    (4, 'inline_statement', _define_57),
    (3, 'closed_dims', _plain_more_58),
    (3, 'closed_dims', _more_56),
    (3, 'open_dims', _more_56),
    (3, 'typed', _variable_59),
    (3, 'valued', _valued_variable_60),
    (3, 'open_dims', _more_values_61),
    (3, 'closed_dims', _more_56),
    (3, 'open_dims', _more_56),
    (1, 'parameter', _parameter_62),
    (1, 'leading', None),
    (1, 'leading', None),
    (2, 'parameters', _none_63),
    (1, 'parameter_list', _one_12),
    (3, 'name{word}', _name_empty_30),
    (3, 'atom', 4),
    (3, 'and{atom}', _and_65),
    (3, 'power{atom}', 0),
    (3, 'bit_and_not{atom}', 0),
    (3, 'bit_and{atom}', 0),
    (3, 'bit_or_not{atom}', 0),
    (3, 'bit_or{atom}', 0),
    (3, 'bit_or_not{atom}', 0),
    (3, 'compare_not{atom}', 0),
    (3, 'compare{atom}', 0),
    (3, 'compare_not{atom}', 0),
    (3, 'compare_not{atom}', 0),
    (3, 'compare{atom}', 0),
    (3, 'compare_not{atom}', 0),
    (4, 'if_head', _if_67),
    (2, 'line_then', _skip_4),
    (1, 'closed', _one_12),
    (1, 'line_tail', None),
    (1, 'closed', None),
    (1, 'inline', _one_12),
    (1, 'line_tail', _one_12),
    (4, 'line_if', _line_if_68),
    (3, 'ref{name{word}}', _member_46),
    (3, 'or{atom}', _or_69),
    (3, 'or{atom}', _xor_70),
    (3, 'shift{atom}', 0),
    (3, 'sum{atom}', 0),
    (3, 'sum{atom}', 0),
    (3, 'term{atom}', 0),
    (3, 'term{atom}', _mod_71),
    (3, 'term{atom}', _mod_71),
    (3, 'term{atom}', 0),
    (4, 'inline_statement', _input_72),
    (4, 'inline_statement', _input_72),
    (1, 'formats', _one_12),
    (4, 'inline_statement', _input_73),
    (1, 'end_loop', None),
    (1, 'end_loop', None),
    (4, 'inline_statement', _loop_74),
    (4, 'name{NAME}', 3),
    (4, 'name{NAME}', _name_args_52),
    (4, 'name{NAME}', _name_axes_53),
    (3, 'and{operand}', _and_65),
    (3, 'power{operand}', 0),
    (3, 'bare', _more_56),
    (2, 'rest', _rest_75),
    (2, 'rest', _rest_last_76),
    (3, 'bit_and_not{operand}', 0),
    (3, 'bit_and{operand}', 0),
    (3, 'bit_or_not{operand}', 0),
    (3, 'bit_or{operand}', 0),
    (3, 'bit_or_not{operand}', 0),
    (3, 'compare_not{operand}', 0),
    (3, 'compare{operand}', 0),
    (3, 'compare_not{operand}', 0),
    (3, 'compare_not{operand}', 0),
    (3, 'compare{operand}', 0),
    (3, 'compare_not{operand}', 0),
    (3, 'or{operand}', _or_69),
    (3, 'or{operand}', _xor_70),
    (3, 'shift{operand}', 0),
    (3, 'sum{operand}', 0),
    (3, 'sum{operand}', 0),
    (3, 'term{operand}', 0),
    (3, 'term{operand}', _mod_71),
    (3, 'term{operand}', _mod_71),
    (3, 'term{operand}', 0),
    (3, 'print_list', _print_item_77),
    (3, 'print_list', _print_item_77),
    (2, 'seps', _skip_4),
    (4, 'inline_statement', _for_78),
    (3, 'body', 1),
    (3, 'body', 1),
    (3, 'body', 1),
    (2, 'else_if', _skip_4),
    (2, 'end_if', _skip_4),
    (1, 'test', _test_79),
    (1, 'tests', _one_12),
    (4, 'select', _last_case_80),
    (2, 'slots', _one_81),
    (4, 'inline_statement', _assign_same_82),
    (2, 'slots', _next_omitted_83),
    (2, 'values', _last_84),
    (4, 'inline_statement', _assign_85),
    (3, 'several', _pair_86),
    (3, 'several', _more_56),
    (3, 'exprs', _more_56),
    (4, 'declared', 3),
    (4, 'declared', _name_args_52),
    (2, 'parameter', _parameter_by_reference_87),
    (2, 'parameter', _parameter_by_value_88),
    (3, 'parameters', 4),
    (4, 'name{word}', 3),
    (4, 'name{word}', _name_args_52),
    (4, 'name{word}', _name_axes_53),
    (2, 'inline', _skip_4),
    (5, 'inline_statement', _input_89),
    (2, 'end_loop', _skip_4),
    (3, 'rest', _rest_90),
    (5, 'inline_statement', _print_91),
    (3, 'print_last', _last_using_92),
    (5, 'inline_statement', _repeat_93),
    (5, 'select_head', _select_94),
    (5, 'declaration', _startup_95),
    (2, 'task_body', _skip_4),
    (2, 'task_body', _label_before_9),
    (1, 'member_list', _one_12),
    (1, 'end_while', None),
    (1, 'end_while', None),
    (1, 'end_while', None),
    (5, 'inline_statement', _while_96),
    (5, 'if_head', _else_if_97),
    (5, 'if_head', _else_if_97),
    (3, 'case', _case_else_98),
    (3, 'case', _case_99),
    (3, 'slots', 1),
    (3, 'type', _sized_type_100),
    (5, 'constant', _constant_101),
    (5, 'valued', _typed_variable_102),
    (6, 'declaration', _event_103),
    (3, 'parameter', _parameter_104),
    (3, 'parameter', _parameter_105),
    (3, 'parameter_list', _more_56),
    (2, 'line_else', _skip_4),
    (6, 'line_if', _line_if_else_106),
    (3, 'closed', _more_56),
    (3, 'inline', _more_56),
    (3, 'line_tail', _more_56),
    (6, 'inline_statement', _input_107),
    (6, 'inline_statement', _input_107),
    (3, 'formats', _pair_86),
    (4, 'rest', _rest_using_108),
    (6, 'inline_statement', _print_109),
    (4, 'print_last', _last_open_110),
    (5, 'print_list', _print_using_111),
    (6, 'select', _select_nothing_112),
    (6, 'declaration', _task_113),
    (3, 'task_body', 1),
    (3, 'task_body', 1),
    (3, 'task_body', 1),
    (3, 'task_body', 1),
    (3, 'task_body', 1),
    (6, 'declaration', _user_type_114),
    (3, 'members', _extend_115),
    (3, 'members', _extend_115),
    (2, 'end_while', _skip_4),
    (5, 'shared', _shared_further_116),
    (6, 'statement', _if_else_117),
    (6, 'ref{name{leading}}', _member_args_118),
    (6, 'ref{name{NAME}}', _member_args_118),
    (3, 'test', _test_is_119),
    (3, 'test', _test_is_119),
    (3, 'test', _test_range_120),
    (3, 'tests', _more_56),
    (7, 'for_head', _for_head_121),
    (4, 'parameter', _parameter_by_reference_122),
    (4, 'parameter', _parameter_by_reference_123),
    (4, 'parameter', _parameter_by_value_124),
    (4, 'parameter', _parameter_by_value_125),
    (7, 'routine', _function_126),
    (6, 'ref{name{word}}', _member_args_118),
    (7, 'inline_statement', _input_127),
    (7, 'inline_statement', _input_127),
    (7, 'inline_statement', _input_128),
    (5, 'rest', _rest_using_129),
    (7, 'routine', _sub_130),
    (4, 'members', _extend_131),
    (4, 'members', _extend_131),
    (3, 'member_list', _more_56),
    (6, 'shared', _shared_132),
    (5, 'parameter', _parameter_133),
    (6, 'rest', _rest_using_two_134),
    (6, 'rest', _rest_using_two_134),
    (7, 'print_list', _print_using_two_135),
    (7, 'print_list', _print_using_two_135),
    (9, 'for_head', _for_head_136),
    (6, 'parameter', _parameter_by_reference_137),
    (6, 'parameter', _parameter_by_value_138),
    (9, 'routine', _function_139),
    (6, 'closed_if', _line_if_else_106),
    (9, 'inline_statement', _input_140),
    (9, 'inline_statement', _input_140),
    (7, 'rest', _rest_using_two_141),
    (7, 'rest', _rest_using_two_141),
)

ROWS = (
    '1=items 2=start d0',
    '3=AUTO 4=BYREF,BYVAL,NV,STEP,TO,USING,leading 5=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 11=EVENT 12=EXIT 13=FOR 14=FUNCTION 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 28=STARTUP 29=SUB 30=TASK 31=TYPE 32=WHILE 33=_NL 34=axes 35=call 36=declaration,routine 37=for_head 38=if_head 39=inline_statement,select,statement 40=line_if 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target d1',
    '',
    'r2=COLON,ELSE,_NL d3',
    '46=LPAR 47=LSQB d4',
    'd5',
    '48=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 49=constant 50=constants',
    '51=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '52=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 53=NV 54=closed_dims 55=declared 56=dims 57=open_dims 58=typed 59=valued',
    'd6',
    '60=NAME d7',
    '61=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d8',
    '62=EVENT,FOR,FUNCTION,LOOP,REPEAT,SELECT,SUB,TASK,WHILE,exit_kind d9',
    '63=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '64=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '65=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word 66=HASH',
    '67=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word 68=HASH',
    '69=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 84=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 90=HASH 91=STRING 92=axes,variable 85=name{word},ref{name{word}} d10',
    '93=COLON,_NL,sep',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 94=COMPLEMENT 9=DOTTED 95=LPAR 96=LSQB 97=MINUS 75=NOT 76=NUMBER 98=PLUS 78=STRING 99=and{operand},bit_and_not{operand},bit_or_not{operand},compare_not{operand},negated,not{operand} 100=axes,operand,power{operand},unary{operand},variable 101=bare 102=bit_and{operand} 103=bit_or{operand} 104=compare{operand} 85=name{word},ref{name{word}} 105=or{operand} 106=shift{operand} 107=sum{operand} 108=term{operand} d11',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 109=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '110=HASH 111=print_list d12',
    '112=COLON,_NL,sep',
    'd13',
    '113=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d14',
    '114=CASE',
    '115=COLON,_NL,sep d15',
    '116=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '117=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d16',
    '118=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d17',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 119=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    'd18',
    'r19=EQUAL d20',
    'd21',
    '120=COLON 121=_NL',
    '122=body 123=shared d22',
    '124=body d22',
    '125=COLON 126=_NL',
    '127=_NL',
    'r23=DOT,EQUAL d24',
    '128=DOT d25',
    '129=DOT d26',
    '130=body d22',
    '131=EQUAL',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 132=RPAR 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 133=expr 85=name{word},ref{name{word}} 86=or{atom} 134=several 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 135=expr 136=exprs 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '137=AS 138=EQUAL',
    'd27',
    '139=COMMA d28',
    '140=EQUAL',
    '141=LPAR d29',
    '52=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 54=closed_dims 55=declared 142=dims 57=open_dims 58=typed 59=valued d30',
    '143=COMMA d31',
    '144=AS 145=EQUAL d32',
    'd33',
    '146=COMMA d34',
    'd35',
    'd36',
    'd37',
    '147=COLON,_NL,sep',
    'd38',
    '148=EQUAL',
    '149=LPAR 150=parameters d39',
    'd40',
    '151=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word',
    'd41',
    '152=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word',
    'd42',
    '153=LPAR 154=LSQB d43',
    'd44',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 155=atom,axes,operand,unary{atom},variable 85=name{word},ref{name{word}}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 156=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 157=atom,axes,operand,unary{atom},variable 85=name{word},ref{name{word}}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 158=bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 85=name{word},ref{name{word}} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    'd45',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 159=atom,axes,operand,unary{atom},variable 85=name{word},ref{name{word}}',
    'd46',
    '160=AND d47',
    '161=CIRCUMFLEX d48',
    '162=AMPERSAND d49',
    '163=VBAR d50',
    '164=COMPARE 165=EQUAL d51',
    '166=DO 167=THEN 168=line_then',
    '169=DOT d52',
    '170=OR 171=XOR d53',
    '172=SHIFT d54',
    '173=MINUS 174=PLUS d55',
    '175=DIVIDE 176=MOD 177=PERCENT 178=STAR d56',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 179=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '180=COMMA 181=SEMICOLON',
    '182=USING d57',
    '183=body d22',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 184=atom,axes,operand,unary{atom},variable 85=name{word},ref{name{word}}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 185=RPAR 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 186=expr 85=name{word},ref{name{word}} 86=or{atom} 187=several 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 135=expr 188=exprs 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 189=atom,axes,operand,unary{atom},variable 85=name{word},ref{name{word}}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 190=atom,axes,operand,unary{atom},variable 85=name{word},ref{name{word}}',
    '191=AND d58',
    '192=CIRCUMFLEX d59',
    '193=COMMA 194=SEMICOLON 195=USING 196=rest d60',
    '197=AMPERSAND d61',
    '198=VBAR d62',
    '199=COMPARE 200=EQUAL d63',
    '201=OR 202=XOR d64',
    '203=SHIFT d65',
    '204=MINUS 205=PLUS d66',
    '206=DIVIDE 207=MOD 208=PERCENT 209=STAR d67',
    'd68',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 210=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 211=expr 85=name{word},ref{name{word}} 86=or{atom} 212=print_last 87=shift{atom} 88=sum{atom} 89=term{atom} d69',
    '213=body d22',
    'd70',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 214=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '215=body d22',
    '149=LPAR 216=parameters d39',
    '217=COLON,_NL,sep',
    '218=COLON,_NL,sep 219=seps',
    '220=COLON,_NL,sep',
    'd71',
    'd72',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 221=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 222=NEXT 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 223=_NL 34=axes 35=call 224=for_head 38=if_head 225=inline_statement,select,statement 226=line_if 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target',
    '227=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 221=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 228=ELSE 229=ELSEIF,else_if 230=END 231=ENDIF 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 223=_NL 34=axes 35=call 232=end_if 37=for_head 38=if_head 225=inline_statement,select,statement 226=line_if 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target',
    'd73',
    'd74',
    'd75',
    '233=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '234=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 235=CASE 221=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 236=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 223=_NL 34=axes 35=call 237=case 37=for_head 38=if_head 225=inline_statement,select,statement 226=line_if 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 238=COMMA 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 239=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 240=slots 88=sum{atom} 89=term{atom} 241=values',
    'd76',
    '242=COMMA 243=RPAR',
    '244=COMMA 245=RPAR',
    'd77',
    '246=COMMA 247=RSQB',
    '248=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 249=type',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 250=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '48=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 251=constant',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 252=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 253=expr 85=name{word},ref{name{word}} 86=or{atom} 254=several 87=shift{atom} 88=sum{atom} 89=term{atom}',
    'd78',
    '52=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 255=declared 256=typed 257=valued',
    '248=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 258=type',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 259=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '260=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 261=bit_and{atom} 262=bit_or{atom} 263=declared 85=name{word},ref{name{word}} 87=shift{atom} 88=sum{atom} 89=term{atom} 264=typed 265=valued',
    '266=body d22',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 267=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '268=AUTO,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 269=BYREF 270=BYVAL 271=RPAR 272=parameter 273=parameter_list',
    '274=AS 275=COLON,_NL,sep',
    'd79',
    'd80',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 276=RPAR 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 277=expr 85=name{word},ref{name{word}} 86=or{atom} 278=several 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 135=expr 279=exprs 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    'd81',
    '280=RPAR',
    'd82',
    'd83',
    'd84',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 281=bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 85=name{word},ref{name{word}} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 282=atom,axes,operand,unary{atom},variable 85=name{word},ref{name{word}}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 85=name{word},ref{name{word}} 283=negated 284=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 285=bit_and_not{atom} 286=bit_and{atom} 85=name{word},ref{name{word}} 287=negated 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 288=bit_and_not{atom},bit_or_not{atom} 81=bit_and{atom} 289=bit_or{atom} 85=name{word},ref{name{word}} 290=negated 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 291=bit_and_not{atom},bit_or_not{atom} 81=bit_and{atom} 292=bit_or{atom} 85=name{word},ref{name{word}} 293=negated 87=shift{atom} 88=sum{atom} 89=term{atom}',
    'd85',
    '294=_NL d86',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 295=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 296=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 297=closed 298=closed_if 37=for_head 299=inline 300=inline_statement,select 301=line_if 302=line_tail 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target',
    '303=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 304=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 85=name{word},ref{name{word}} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 305=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 85=name{word},ref{name{word}} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 85=name{word},ref{name{word}} 306=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 85=name{word},ref{name{word}} 307=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 85=name{word},ref{name{word}} 308=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 309=atom,axes,operand,power{atom},unary{atom},variable 85=name{word},ref{name{word}}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 310=atom,axes,operand,power{atom},unary{atom},variable 85=name{word},ref{name{word}}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 311=atom,axes,operand,power{atom},unary{atom},variable 85=name{word},ref{name{word}}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 312=atom,axes,operand,power{atom},unary{atom},variable 85=name{word},ref{name{word}}',
    '313=COMMA',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 314=axes,variable 85=name{word},ref{name{word}}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 315=axes,variable 85=name{word},ref{name{word}}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 316=expr 317=formats 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 221=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 318=END 319=ENDL 320=ENDLOOP 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 223=_NL 34=axes 35=call 321=end_loop 37=for_head 38=if_head 225=inline_statement,select,statement 226=line_if 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target',
    'd87',
    'd88',
    '242=COMMA 322=RPAR',
    '244=COMMA 323=RPAR',
    '246=COMMA 324=RSQB',
    'd89',
    'd90',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 325=bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 85=name{word},ref{name{word}} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 326=atom,axes,operand,unary{atom},variable 85=name{word},ref{name{word}}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 327=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '328=print_list d12',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 329=expr 330=formats 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    'd91',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 85=name{word},ref{name{word}} 331=negated 332=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 333=bit_and_not{atom} 334=bit_and{atom} 85=name{word},ref{name{word}} 335=negated 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 336=bit_and_not{atom},bit_or_not{atom} 81=bit_and{atom} 337=bit_or{atom} 85=name{word},ref{name{word}} 338=negated 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 339=bit_and_not{atom},bit_or_not{atom} 81=bit_and{atom} 340=bit_or{atom} 85=name{word},ref{name{word}} 341=negated 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 342=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 85=name{word},ref{name{word}} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 343=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 85=name{word},ref{name{word}} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 85=name{word},ref{name{word}} 344=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 85=name{word},ref{name{word}} 345=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 85=name{word},ref{name{word}} 346=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 347=atom,axes,operand,power{atom},unary{atom},variable 85=name{word},ref{name{word}}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 348=atom,axes,operand,power{atom},unary{atom},variable 85=name{word},ref{name{word}}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 349=atom,axes,operand,power{atom},unary{atom},variable 85=name{word},ref{name{word}}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 350=atom,axes,operand,power{atom},unary{atom},variable 85=name{word},ref{name{word}}',
    '351=COMMA',
    '352=COMMA 353=SEMICOLON 354=USING d92',
    'd93',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 221=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 355=UNTIL 32=WHILE 223=_NL 34=axes 35=call 37=for_head 38=if_head 225=inline_statement,select,statement 226=line_if 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target',
    '218=COLON,_NL,sep 356=seps',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 221=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 357=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 223=_NL 34=axes 35=call 37=for_head 38=if_head 225=inline_statement,select,statement 226=line_if 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target',
    '358=COLON,_NL,sep',
    '359=task_body d94',
    'd95',
    '360=COLON,_NL,sep 361=members d96',
    '362=body d22',
    'd97',
    '363=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d98',
    'd99',
    '364=body 365=shared d22',
    '366=COLON 367=_NL',
    '368=_NL',
    'd100',
    '369=COLON,_NL,sep 370=IF',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 371=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '372=IF 60=NAME d7',
    'd101',
    'd102',
    '373=LPAR d103',
    '374=LPAR d104',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 375=ELSE 376=IS 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 377=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom} 378=test 379=tests',
    '60=NAME 380=SELECT d7',
    'd105',
    'd106',
    '381=COMMA 382=SEMICOLON d107',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 383=COMMA 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 384=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '385=SEMICOLON d108',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 386=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    'd109',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 387=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    'd110',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 388=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    'd111',
    '389=STAR d112',
    '390=EQUAL',
    'd113',
    'd114',
    'd115',
    '242=COMMA 391=RPAR',
    '244=COMMA 392=RPAR',
    '144=AS 145=EQUAL d116',
    'd117',
    'd118',
    '393=EQUAL d119',
    'd120',
    'r29=AS,EQUAL 394=LPAR 154=LSQB d43',
    '395=AMPERSAND d49',
    '396=VBAR d121',
    '144=AS 145=EQUAL',
    'd122',
    'd123',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 221=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 397=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 223=_NL 34=axes 35=call 37=for_head 38=if_head 225=inline_statement,select,statement 226=line_if 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target',
    '398=TO',
    '399=AS 400=LPAR d124',
    '401=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d125',
    '402=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d126',
    'd127',
    'd128',
    '403=COMMA 404=RPAR',
    '248=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 405=type',
    '406=body d22',
    'd129',
    '242=COMMA 407=RPAR',
    '244=COMMA 408=RPAR',
    '246=COMMA 409=RSQB',
    'd130',
    'd131',
    'd132',
    'd133',
    '172=SHIFT d134',
    'd135',
    '162=AMPERSAND d136',
    'd137',
    'd138',
    '163=VBAR d139',
    'd140',
    'd141',
    '163=VBAR d142',
    'd143',
    'd144',
    'd145',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 410=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '411=ELSE,line_else',
    'd146',
    '412=COLON r147=_NL d148',
    'd149',
    'd150',
    'd151',
    '413=LPAR d152',
    '160=AND d153',
    '160=AND d154',
    '173=MINUS 174=PLUS d155',
    '175=DIVIDE 176=MOD 177=PERCENT 178=STAR d156',
    '175=DIVIDE 176=MOD 177=PERCENT 178=STAR d157',
    '161=CIRCUMFLEX d158',
    '161=CIRCUMFLEX d159',
    '161=CIRCUMFLEX d160',
    '161=CIRCUMFLEX d161',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 414=STRING 415=axes,variable 85=name{word},ref{name{word}}',
    '416=USING d162',
    '417=USING d163',
    '418=COMMA d164',
    'd165',
    '419=LOOP 60=NAME d7',
    'd166',
    'd167',
    'd168',
    'd169',
    'd170',
    'd171',
    'd172',
    'd173',
    'd174',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 211=expr 85=name{word},ref{name{word}} 86=or{atom} 420=print_last 87=shift{atom} 88=sum{atom} 89=term{atom} d175',
    '421=COMMA 422=SEMICOLON d164',
    'd176',
    'd177',
    '172=SHIFT d178',
    'd179',
    '162=AMPERSAND d180',
    'd181',
    'd182',
    '163=VBAR d183',
    'd184',
    'd185',
    '163=VBAR d186',
    'd187',
    '160=AND d188',
    '160=AND d189',
    '173=MINUS 174=PLUS d190',
    '175=DIVIDE 176=MOD 177=PERCENT 178=STAR d191',
    '175=DIVIDE 176=MOD 177=PERCENT 178=STAR d192',
    '161=CIRCUMFLEX d193',
    '161=CIRCUMFLEX d194',
    '161=CIRCUMFLEX d195',
    '161=CIRCUMFLEX d196',
    '423=print_list d12',
    'd197',
    'd198',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 424=expr 425=formats 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 426=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '235=CASE 360=COLON,_NL,sep 427=END 428=case',
    '60=NAME 429=STARTUP d7',
    '430=body d22',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 431=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 432=END 12=EXIT 13=FOR 14=FUNCTION 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 29=SUB 32=WHILE 433=_NL 34=axes 35=call 37=for_head 38=if_head 434=inline_statement,select,statement 435=line_if 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 436=routine 44=select_head 45=target',
    'd199',
    '52=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 437=DIM 438=END 439=declared 440=member_list 441=typed',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 221=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 442=END 443=ENDW 444=ENDWHILE 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 445=WEND 32=WHILE 223=_NL 34=axes 35=call 446=end_while 37=for_head 38=if_head 225=inline_statement,select,statement 226=line_if 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target',
    'd200',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 221=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 447=NEXT 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 223=_NL 34=axes 35=call 224=for_head 38=if_head 225=inline_statement,select,statement 226=line_if 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target',
    '448=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd201',
    'd202',
    'd203',
    '449=body d22',
    'd204',
    '450=DO 451=THEN',
    'd205',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 135=expr 452=exprs 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 135=expr 453=exprs 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '454=COLON,_NL,sep',
    '455=COMPARE 456=EQUAL',
    '457=TO d206',
    'd207',
    '458=COLON,_NL,sep 459=COMMA',
    'd208',
    'd209',
    'd210',
    'd211',
    '460=COMMA d212',
    'd213',
    'd214',
    'd215',
    'd216',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 461=atom,axes,operand,unary{atom},variable 85=name{word},ref{name{word}}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 462=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    'd217',
    'd218',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 463=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 276=RPAR 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 464=expr 85=name{word},ref{name{word}} 86=or{atom} 465=several 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 85=name{word},ref{name{word}} 284=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 76=NUMBER 77=PLUS 78=STRING 80=atom,axes,operand,power{atom},unary{atom},variable 466=bit_and{atom} 85=name{word},ref{name{word}} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '467=EVENT 60=NAME d7',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 468=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '248=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 469=type',
    '470=RPAR',
    '471=AS 472=LPAR d219',
    '473=AS 474=LPAR d220',
    '268=AUTO,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 269=BYREF 270=BYVAL 475=parameter',
    'd221',
    '476=COLON,_NL,sep',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 221=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 477=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 223=_NL 34=axes 35=call 37=for_head 38=if_head 225=inline_statement,select,statement 226=line_if 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target',
    'd222',
    'd223',
    'd224',
    '478=THEN,line_then',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 479=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 480=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 37=for_head 481=inline 300=inline_statement,select 301=line_if 482=line_tail 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 296=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 483=closed_if 37=for_head 484=inline_statement,select 485=line_if 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target d225',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 135=expr 486=exprs 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '487=COMMA 488=SEMICOLON',
    '489=USING d226',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 316=expr 490=formats 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 316=expr 491=formats 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 492=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    'd227',
    'd228',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 493=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '494=print_list d12',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 211=expr 85=name{word},ref{name{word}} 86=or{atom} 495=print_last 87=shift{atom} 88=sum{atom} 89=term{atom} d229',
    '496=COMMA 497=SEMICOLON d164',
    'd230',
    'd231',
    '498=SELECT',
    'd232',
    'd233',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 221=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 499=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 223=_NL 34=axes 35=call 37=for_head 38=if_head 225=inline_statement,select,statement 226=line_if 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target',
    'd234',
    '60=NAME 500=TASK d7',
    'd235',
    '501=COLON 502=_NL',
    '503=_NL',
    '504=COLON 505=_NL',
    '52=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 439=declared 506=member_list 441=typed',
    '507=TYPE',
    '508=AS',
    '509=COLON 510=COMMA 511=_NL',
    'd236',
    '60=NAME 512=WHILE d7',
    'd237',
    'd238',
    'd239',
    'd240',
    '513=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d98',
    '514=COMMA d100',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 221=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 230=END 231=ENDIF 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 223=_NL 34=axes 35=call 515=end_if 37=for_head 38=if_head 225=inline_statement,select,statement 226=line_if 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target',
    'd241',
    'd242',
    '246=COMMA 516=RPAR',
    '246=COMMA 517=RPAR',
    'd243',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 518=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 519=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 520=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    'd244',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 376=IS 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 377=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom} 521=test',
    'd245',
    'd246',
    'd247',
    'd248',
    '242=COMMA 522=RPAR',
    '244=COMMA 523=RPAR',
    '395=AMPERSAND d136',
    'd249',
    '524=COLON,_NL,sep 525=STEP',
    'd250',
    '526=AS d251',
    '248=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 527=type',
    '528=RPAR',
    '248=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 529=type',
    '530=RPAR',
    'd252',
    '531=body d22',
    '532=FUNCTION 60=NAME d7',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 295=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 296=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 533=closed 298=closed_if 37=for_head 299=inline 300=inline_statement,select 301=line_if 302=line_tail 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target',
    'd253',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 534=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '535=COLON d147',
    'd254',
    'd255',
    'd256',
    'd257',
    '246=COMMA 536=RPAR',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 537=axes,variable 85=name{word},ref{name{word}}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 538=axes,variable 85=name{word},ref{name{word}}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 316=expr 539=formats 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    'd258',
    'd259',
    'd260',
    '540=COMMA 541=SEMICOLON d260',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 211=expr 85=name{word},ref{name{word}} 86=or{atom} 542=print_last 87=shift{atom} 88=sum{atom} 89=term{atom} d261',
    'd262',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 543=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom} d263',
    'd264',
    'd265',
    '60=NAME 544=SUB d7',
    'd266',
    'd267',
    'd268',
    'd269',
    'd270',
    'd271',
    '545=COLON 510=COMMA 546=_NL',
    'd272',
    '248=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 547=type',
    'd273',
    '52=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 439=declared 548=typed',
    'd274',
    'd275',
    '549=COMMA d200',
    'd276',
    'd277',
    'd278',
    'd279',
    'd280',
    'd281',
    'd282',
    'd283',
    'r217=AS,EQUAL d222',
    'r218=AS,EQUAL d223',
    'd284',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 550=expr 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '248=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 551=type',
    'd285',
    '552=AS d286',
    'd287',
    '553=AS d288',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 221=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 554=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 223=_NL 34=axes 35=call 37=for_head 38=if_head 225=inline_statement,select,statement 226=line_if 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target',
    'd289',
    '555=ELSE,line_else',
    '168=THEN,line_then',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 480=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 37=for_head 484=inline_statement,select 485=line_if 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target d225',
    'd290',
    '556=USING d291',
    '557=USING d292',
    'd293',
    '558=print_list d12',
    '559=print_list d12',
    'd294',
    '560=COMMA 561=SEMICOLON d260',
    'd295',
    'd296',
    'd297',
    'd119',
    'd298',
    'd299',
    '562=COLON,_NL,sep',
    'd300',
    '248=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 563=type',
    '248=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 564=type',
    '565=FUNCTION 60=NAME d7',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 479=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 296=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 566=closed 298=closed_if 37=for_head 299=inline 300=inline_statement,select 301=line_if 482=line_tail 41=name{NAME} 42=name{leading},ref{name{leading}} 43=ref{name{NAME}} 44=select_head 45=target',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 316=expr 567=formats 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 316=expr 568=formats 85=name{word},ref{name{word}} 86=or{atom} 87=shift{atom} 88=sum{atom} 89=term{atom}',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 211=expr 85=name{word},ref{name{word}} 86=or{atom} 569=print_last 87=shift{atom} 88=sum{atom} 89=term{atom} d301',
    '70=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 71=CHARACTER 72=COMPLEMENT 9=DOTTED 73=LPAR 74=MINUS 75=NOT 76=NUMBER 77=PLUS 78=STRING 79=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=atom,axes,operand,power{atom},unary{atom},variable 81=bit_and{atom} 82=bit_or{atom} 83=compare{atom} 211=expr 85=name{word},ref{name{word}} 86=or{atom} 570=print_last 87=shift{atom} 88=sum{atom} 89=term{atom} d302',
    'd303',
    'd304',
    'd305',
    'd306',
    'd307',
    'd308',
    'd309',
    'd310',
    'd311',
    'd312',
    'd313',
)

LEAVES = {
    'NUMBER': (1, _number_22),
    'NAME': (2, _name_3),
}

TABLES = Tables(TOKEN, CONTINUED, LITERALS, CLASSES, RULES, ROWS, 2, LEAVES, _run)
