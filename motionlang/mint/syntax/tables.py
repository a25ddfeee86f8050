"""The tables of grammars/mint.lark; written by `python -m motionlang.lang.parsing.generate`, not by hand."""

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


def _line_print_38(S, M, top, T):
    (S, _, v0), _, v1 = S
    top = line_print(v0, T[v0], v1, top)
    return S, top


def _last_item_39(S, M, top, T):
    n = new(PrintItem)
    n.at = top.at
    n.value = top
    n.using = []
    n.separator = ''
    top = n
    return S, top


def _print_40(S, M, top, T):
    (S, _, v0), _, v1 = S
    n = new(Print)
    n.at = v0
    n.items = v1 if top is None else [*v1, top]
    n.terminal = None
    n.word = ''
    n.line = None
    top = n
    return S, top


def _none_41(S, M, top, T):
    top = []
    return S, top


def _for_42(S, M, top, T):
    (S, _, v0), _, v1 = S
    top = counted(v0, v1, None, T)
    return S, top


def _for_shared_43(S, M, top, T):
    (S, _, v0), _, v1 = S
    top = counted(v0, v1, top, T)
    return S, top


def _member_44(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Member)
    n.at = v0.at
    n.value = v0
    n.field = T[top]
    n.args = None
    top = n
    return S, top


def _next_case_45(S, M, top, T):
    (S, _, v0), _, v1 = S
    top = next_case(v0, v1, top)
    return S, top


def _one_omitted_46(S, M, top, T):
    top = [Omitted(top)]
    return S, top


def _assign_48(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Assign)
    n.at = v0.at
    n.target = v0
    n.values = top
    n.repeat = None is not None
    top = n
    return S, top


def _name_args_50(S, M, top, T):
    ((S, _, v0), _, _), _, v2 = S
    n = new(Name)
    n.at = v0
    n.name = T[v0]
    n.args = v2
    n.axes = False
    top = n
    return S, top


def _name_axes_51(S, M, top, T):
    ((S, _, v0), _, _), _, v2 = S
    n = new(Name)
    n.at = v0
    n.name = T[v0]
    n.args = v2
    n.axes = True
    top = n
    return S, top


def _type_52(S, M, top, T):
    n = new(TypeName)
    n.at = top
    n.name = T[top]
    n.size = None
    top = n
    return S, top


def _constant_53(S, M, top, T):
    (S, _, v0), _, _ = S
    top = Const(v0, T[v0], None, top)
    return S, top


def _more_54(S, M, top, T):
    (S, _, v0), _, _ = S
    v0.append(top)
    top = v0
    return S, top


def _define_55(S, M, top, T):
    ((S, _, v0), _, v1), _, _ = S
    n = new(Define)
    n.at = v0
    n.name = T[v1]
    n.value = top
    top = n
    return S, top


def _plain_more_56(S, M, top, T):
    (S, _, v0), _, _ = S
    v0.append(declare(top))
    top = v0
    return S, top


def _variable_57(S, M, top, T):
    (S, _, v0), _, _ = S
    top = declare(v0, top)
    return S, top


def _valued_variable_58(S, M, top, T):
    (S, _, v0), _, _ = S
    top = declare(v0, None, top)
    return S, top


def _more_values_59(S, M, top, T):
    (S, _, v0), _, _ = S
    top = more_values(v0, top)
    return S, top


def _parameter_60(S, M, top, T):
    n = new(Parameter)
    n.at = top
    n.name = T[top]
    n.type = None
    n.by_ref = False
    n.is_array = None is not None
    top = n
    return S, top


def _none_61(S, M, top, T):
    S, _, _ = S
    top = []
    return S, top


def _and_63(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Binary)
    n.at = v0.at
    n.op = 'And'
    n.left = v0
    n.right = top
    top = n
    return S, top


def _line_if_65(S, M, top, T):
    ((S, _, v0), _, v1), _, _ = S
    n = new(If)
    n.at = v0
    n.condition = v1
    n.body = top
    n.orelse = []
    top = n
    return S, top


def _or_66(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Binary)
    n.at = v0.at
    n.op = 'Or'
    n.left = v0
    n.right = top
    top = n
    return S, top


def _xor_67(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Binary)
    n.at = v0.at
    n.op = 'Xor'
    n.left = v0
    n.right = top
    top = n
    return S, top


def _mod_68(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Binary)
    n.at = v0.at
    n.op = 'Mod'
    n.left = v0
    n.right = top
    top = n
    return S, top


def _input_69(S, M, top, T):
    ((S, _, v0), _, v1), _, _ = S
    n = new(Input)
    n.at = v0
    n.target = top
    n.prompt = None if v1 is None else String(v1, string(T[v1]))
    n.using = None or []
    n.terminal = None
    top = n
    return S, top


def _input_70(S, M, top, T):
    ((S, _, v0), _, v1), _, _ = S
    n = new(Input)
    n.at = v0
    n.target = v1
    n.prompt = None if None is None else String(None, string(T[None]))
    n.using = top or []
    n.terminal = None
    top = n
    return S, top


def _loop_71(S, M, top, T):
    ((S, _, v0), _, _), _, v2 = S
    n = new(Loop)
    n.at = v0
    n.body = v2
    top = n
    return S, top


def _rest_72(S, M, top, T):
    S, _, v0 = S
    top = printed(top, None, [], T[v0])
    return S, top


def _rest_last_73(S, M, top, T):
    S, _, _ = S
    top = printed([], None, top, "")
    return S, top


def _print_item_74(S, M, top, T):
    (S, _, v0), _, v1 = S
    n = new(PrintItem)
    n.at = v1.at
    n.value = v1
    n.using = []
    n.separator = T[top]
    v0.append(n)
    top = v0
    return S, top


def _for_75(S, M, top, T):
    ((S, _, v0), _, v1), _, _ = S
    top = counted(v0, v1, top, T)
    return S, top


def _test_76(S, M, top, T):
    n = new(CaseTest)
    n.at = top.at
    n.op = '='
    n.value = top
    n.high = None
    top = n
    return S, top


def _last_case_77(S, M, top, T):
    ((S, _, v0), _, v1), _, _ = S
    top = last_case(v0, v1)
    return S, top


def _one_78(S, M, top, T):
    S, _, v0 = S
    top = [v0]
    return S, top


def _assign_same_79(S, M, top, T):
    ((S, _, v0), _, _), _, v2 = S
    n = new(Assign)
    n.at = v0.at
    n.target = v0
    n.values = [v2]
    n.repeat = True
    top = n
    return S, top


def _next_omitted_80(S, M, top, T):
    S, _, v0 = S
    n = new(Omitted)
    n.at = top
    v0.append(n)
    top = v0
    return S, top


def _last_81(S, M, top, T):
    S, _, v0 = S
    v0.append(top)
    top = v0
    return S, top


def _assign_82(S, M, top, T):
    ((S, _, v0), _, _), _, v2 = S
    n = new(Assign)
    n.at = v0.at
    n.target = v0
    n.values = v2
    n.repeat = top is not None
    top = n
    return S, top


def _pair_83(S, M, top, T):
    (S, _, v0), _, _ = S
    top = [v0, top]
    return S, top


def _parameter_by_reference_84(S, M, top, T):
    S, _, v0 = S
    n = new(Parameter)
    n.at = v0
    n.name = T[top]
    n.type = None
    n.by_ref = True
    n.is_array = None is not None
    top = n
    return S, top


def _parameter_by_value_85(S, M, top, T):
    S, _, v0 = S
    n = new(Parameter)
    n.at = v0
    n.name = T[top]
    n.type = None
    n.by_ref = False
    n.is_array = None is not None
    top = n
    return S, top


def _if_do_86(S, M, top, T):
    (((S, _, v0), _, v1), _, _), _, v3 = S
    n = new(If)
    n.at = v0
    n.condition = v1
    n.body = v3
    n.orelse = top
    top = n
    return S, top


def _input_87(S, M, top, T):
    (((S, _, v0), _, _), _, v2), _, _ = S
    n = new(Input)
    n.at = v0
    n.target = top
    n.prompt = None if None is None else String(None, string(T[None]))
    n.using = None or []
    n.terminal = v2
    top = n
    return S, top


def _rest_88(S, M, top, T):
    (S, _, v0), _, v1 = S
    top = printed(v1, top, [], T[v0])
    return S, top


def _print_89(S, M, top, T):
    (((S, _, v0), _, _), _, v2), _, _ = S
    n = new(Print)
    n.at = v0
    n.items = top if None is None else [*top, None]
    n.terminal = v2
    n.word = ''
    n.line = None
    top = n
    return S, top


def _last_using_90(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(PrintItem)
    n.at = v0.at
    n.value = v0
    n.using = top
    n.separator = ''
    top = n
    return S, top


def _repeat_91(S, M, top, T):
    (((S, _, v0), _, _), _, v2), _, _ = S
    n = new(Repeat)
    n.at = v0
    n.body = v2
    n.condition = top
    top = n
    return S, top


def _select_92(S, M, top, T):
    (((S, _, v0), _, _), _, v2), _, _ = S
    n = new(Select)
    n.at = v0
    n.subject = v2
    n.cases = [top]
    top = n
    return S, top


def _startup_93(S, M, top, T):
    (((S, _, v0), _, _), _, v2), _, _ = S
    n = new(Startup)
    n.at = v0
    n.body = v2
    top = n
    return S, top


def _while_94(S, M, top, T):
    (((S, _, v0), _, v1), _, _), _, v3 = S
    n = new(While)
    n.at = v0
    n.condition = v1
    n.body = v3
    top = n
    return S, top


def _case_else_95(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Case)
    n.at = v0
    n.tests = []
    n.body = []
    top = n
    return S, top


def _case_96(S, M, top, T):
    (S, _, v0), _, v1 = S
    n = new(Case)
    n.at = v0
    n.tests = v1
    n.body = []
    top = n
    return S, top


def _sized_type_97(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(TypeName)
    n.at = v0
    n.name = T[v0]
    n.size = top
    top = n
    return S, top


def _constant_98(S, M, top, T):
    (((S, _, v0), _, _), _, v2), _, _ = S
    top = Const(v0, T[v0], v2, top)
    return S, top


def _typed_variable_99(S, M, top, T):
    (((S, _, v0), _, _), _, v2), _, _ = S
    top = declare(v0, v2, top)
    return S, top


def _event_100(S, M, top, T):
    ((((S, _, v0), _, v1), _, _), _, v3), _, _ = S
    n = new(Event)
    n.at = v0
    n.name = T[v1]
    n.body = v3
    top = n
    return S, top


def _parameter_101(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v0]
    n.type = top
    n.by_ref = False
    n.is_array = None is not None
    top = n
    return S, top


def _parameter_102(S, M, top, T):
    (S, _, v0), _, v1 = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v0]
    n.type = None
    n.by_ref = False
    n.is_array = v1 is not None
    top = n
    return S, top


def _if_103(S, M, top, T):
    ((((S, _, v0), _, v1), _, _), _, _), _, v4 = S
    n = new(If)
    n.at = v0
    n.condition = v1
    n.body = v4
    n.orelse = top
    top = n
    return S, top


def _line_if_else_104(S, M, top, T):
    ((((S, _, v0), _, v1), _, _), _, v3), _, _ = S
    n = new(If)
    n.at = v0
    n.condition = v1
    n.body = v3
    n.orelse = top
    top = n
    return S, top


def _input_105(S, M, top, T):
    ((((S, _, v0), _, v1), _, _), _, v3), _, _ = S
    n = new(Input)
    n.at = v0
    n.target = v3
    n.prompt = None if v1 is None else String(v1, string(T[v1]))
    n.using = top or []
    n.terminal = None
    top = n
    return S, top


def _rest_using_106(S, M, top, T):
    ((S, _, _), _, v1), _, v2 = S
    top = printed(top, None, [v1], T[v2])
    return S, top


def _print_107(S, M, top, T):
    ((((S, _, v0), _, _), _, v2), _, _), _, v4 = S
    n = new(Print)
    n.at = v0
    n.items = v4 if top is None else [*v4, top]
    n.terminal = v2
    n.word = ''
    n.line = None
    top = n
    return S, top


def _last_open_108(S, M, top, T):
    ((S, _, v0), _, _), _, v2 = S
    n = new(PrintItem)
    n.at = v0.at
    n.value = v0
    n.using = [v2]
    n.separator = ','
    top = n
    return S, top


def _print_using_109(S, M, top, T):
    (((S, _, v0), _, v1), _, _), _, v3 = S
    n = new(PrintItem)
    n.at = v1.at
    n.value = v1
    n.using = [v3]
    n.separator = T[top]
    v0.append(n)
    top = v0
    return S, top


def _select_nothing_110(S, M, top, T):
    ((((S, _, v0), _, _), _, v2), _, _), _, _ = S
    n = new(Select)
    n.at = v0
    n.subject = v2
    n.cases = []
    top = n
    return S, top


def _task_111(S, M, top, T):
    ((((S, _, v0), _, v1), _, _), _, v3), _, _ = S
    top = task(v0, T[v1], v3)
    return S, top


def _user_type_112(S, M, top, T):
    ((((S, _, v0), _, v1), _, _), _, v3), _, _ = S
    n = new(UserType)
    n.at = v0
    n.name = T[v1]
    n.members = v3
    top = n
    return S, top


def _extend_113(S, M, top, T):
    (S, _, v0), _, v1 = S
    top = extended(v0, v1)
    return S, top


def _shared_further_114(S, M, top, T):
    (((S, _, v0), _, v1), _, v2), _, v3 = S
    v0.append(counted(v1, v2, v3, T))
    top = v0
    return S, top


def _member_args_115(S, M, top, T):
    ((((S, _, v0), _, _), _, v2), _, _), _, v4 = S
    n = new(Member)
    n.at = v0.at
    n.value = v0
    n.field = T[v2]
    n.args = v4
    top = n
    return S, top


def _test_is_116(S, M, top, T):
    (S, _, v0), _, v1 = S
    n = new(CaseTest)
    n.at = v0
    n.op = T[v1]
    n.value = top
    n.high = None
    top = n
    return S, top


def _test_range_117(S, M, top, T):
    (S, _, v0), _, _ = S
    n = new(CaseTest)
    n.at = v0.at
    n.op = 'To'
    n.value = v0
    n.high = top
    top = n
    return S, top


def _for_head_118(S, M, top, T):
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


def _parameter_by_reference_119(S, M, top, T):
    ((S, _, v0), _, v1), _, _ = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = top
    n.by_ref = True
    n.is_array = None is not None
    top = n
    return S, top


def _parameter_by_reference_120(S, M, top, T):
    ((S, _, v0), _, v1), _, v2 = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = None
    n.by_ref = True
    n.is_array = v2 is not None
    top = n
    return S, top


def _parameter_by_value_121(S, M, top, T):
    ((S, _, v0), _, v1), _, _ = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = top
    n.by_ref = False
    n.is_array = None is not None
    top = n
    return S, top


def _parameter_by_value_122(S, M, top, T):
    ((S, _, v0), _, v1), _, v2 = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = None
    n.by_ref = False
    n.is_array = v2 is not None
    top = n
    return S, top


def _function_123(S, M, top, T):
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


def _input_124(S, M, top, T):
    (((((S, _, v0), _, _), _, v2), _, _), _, v4), _, _ = S
    n = new(Input)
    n.at = v0
    n.target = top
    n.prompt = None if v4 is None else String(v4, string(T[v4]))
    n.using = None or []
    n.terminal = v2
    top = n
    return S, top


def _input_125(S, M, top, T):
    (((((S, _, v0), _, _), _, v2), _, _), _, v4), _, _ = S
    n = new(Input)
    n.at = v0
    n.target = v4
    n.prompt = None if None is None else String(None, string(T[None]))
    n.using = top or []
    n.terminal = v2
    top = n
    return S, top


def _rest_using_126(S, M, top, T):
    (((S, _, _), _, v1), _, v2), _, v3 = S
    top = printed(v3, top, [v1], T[v2])
    return S, top


def _sub_127(S, M, top, T):
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


def _extend_128(S, M, top, T):
    ((S, _, v0), _, _), _, v2 = S
    top = extended(v0, v2)
    return S, top


def _shared_129(S, M, top, T):
    ((((S, _, v0), _, v1), _, v2), _, _), _, v4 = S
    v0.append(counted(v1, v2, v4, T))
    top = v0
    return S, top


def _parameter_130(S, M, top, T):
    (((S, _, v0), _, v1), _, _), _, _ = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v0]
    n.type = top
    n.by_ref = False
    n.is_array = v1 is not None
    top = n
    return S, top


def _third_131(S, M, top, T):
    ((S, _, _), _, _), _, v2 = S
    top = v2
    return S, top


def _rest_using_two_132(S, M, top, T):
    ((((S, _, _), _, v1), _, _), _, v3), _, v4 = S
    top = printed(top, None, [v1, v3], T[v4])
    return S, top


def _print_using_two_133(S, M, top, T):
    (((((S, _, v0), _, v1), _, _), _, v3), _, _), _, v5 = S
    n = new(PrintItem)
    n.at = v1.at
    n.value = v1
    n.using = [v3, v5]
    n.separator = T[top]
    v0.append(n)
    top = v0
    return S, top


def _for_head_134(S, M, top, T):
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


def _parameter_by_reference_135(S, M, top, T):
    ((((S, _, v0), _, v1), _, v2), _, _), _, _ = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = top
    n.by_ref = True
    n.is_array = v2 is not None
    top = n
    return S, top


def _parameter_by_value_136(S, M, top, T):
    ((((S, _, v0), _, v1), _, v2), _, _), _, _ = S
    n = new(Parameter)
    n.at = v0
    n.name = T[v1]
    n.type = top
    n.by_ref = False
    n.is_array = v2 is not None
    top = n
    return S, top


def _function_137(S, M, top, T):
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


def _else_if_138(S, M, top, T):
    (((S, _, v0), _, v1), _, _), _, v3 = S
    top = [If(v0, v1, v3, top)]
    return S, top


def _input_139(S, M, top, T):
    (((((((S, _, v0), _, _), _, v2), _, _), _, v4), _, _), _, v6), _, _ = S
    n = new(Input)
    n.at = v0
    n.target = v6
    n.prompt = None if v4 is None else String(v4, string(T[v4]))
    n.using = top or []
    n.terminal = v2
    top = n
    return S, top


def _rest_using_two_140(S, M, top, T):
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


TOKEN = '[ \t]*+([!\\#%\\&\\(\\)\\*\\+,\\-/;=\\?\\[\\\\\\]\\^\\|\\~]|[A-Za-z_](?!(?<=[Rr])(?:[Ee][Mm]\\b|(?<=R)EM[A-Z][a-z]))[A-Za-z0-9_]*+(?!\\.[0-9])|[0-9.](?:(?<=[0-9])[0-9]*+\\.?[0-9]*+(?:[eE][+-]?[0-9]++)?|(?<=\\.)[0-9]++(?:[eE][+-]?[0-9]++)?|(?<=0)(?:[xX][0-9a-fA-F]++|[bB][01]++))(?![A-Za-z0-9_])|[\n\':Rr](?:(?<=\n)|(?<=\')[^\n]*+\n|(?:(?<=:)[ \t]*+[Rr])?(?<=[Rr])(?:[Ee][Mm]\\b|(?<=R)EM(?=[A-Z][a-z]))[^\n]*+\n)[ \t]*+(?:(?:\'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)*+|"[^"\\\\\n]*+(?:\\\\[^\n][^"\\\\\n]*+)*+"|[A-Za-z_][A-Za-z0-9_]*+(?:\\.[0-9]++)++|`(?:[^`\\\\\n]|\\\\[^\n])`|<<|<=|<>|>=|>>|"[^\\n]*|[0-9][A-Za-z0-9_]*|.)'

CONTINUED = '(?:[ \t]++|[\\\\_][ \t]*+(?:\'[^\n]*+)?\n)*([!\\#%\\&\\(\\)\\*\\+,\\-/;=\\?\\[\\\\\\]\\^\\|\\~]|[A-Za-z_](?!(?<=[Rr])(?:[Ee][Mm]\\b|(?<=R)EM[A-Z][a-z]))[A-Za-z0-9_]*+(?!\\.[0-9])|[0-9.](?:(?<=[0-9])[0-9]*+\\.?[0-9]*+(?:[eE][+-]?[0-9]++)?|(?<=\\.)[0-9]++(?:[eE][+-]?[0-9]++)?|(?<=0)(?:[xX][0-9a-fA-F]++|[bB][01]++))(?![A-Za-z0-9_])|[\n\':Rr](?:(?<=\n)|(?<=\')[^\n]*+\n|(?:(?<=:)[ \t]*+[Rr])?(?<=[Rr])(?:[Ee][Mm]\\b|(?<=R)EM(?=[A-Z][a-z]))[^\n]*+\n)[ \t]*+(?:(?:\'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)*+|"[^"\\\\\n]*+(?:\\\\[^\n][^"\\\\\n]*+)*+"|[A-Za-z_][A-Za-z0-9_]*+(?:\\.[0-9]++)++|`(?:[^`\\\\\n]|\\\\[^\n])`|<<|<=|<>|>=|>>|"[^\\n]*|[0-9][A-Za-z0-9_]*|.)'

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
    '_NL': "[\n':Rr](?:(?<=\n)|(?<=')[^\n]*+\n|(?:(?<=:)[ \t]*+[Rr])?(?<=[Rr])(?:[Ee][Mm]\\b|(?<=R)EM(?=[A-Z][a-z]))[^\n]*+\n)[ \t]*+(?:(?:'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)*+",
    'STRING': '"[^"\\\\\n]*+(?:\\\\[^\n][^"\\\\\n]*+)*+"',
    'DOTTED': '[A-Za-z_][A-Za-z0-9_]*+(?:\\.[0-9]++)++',
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
    (1, 'line_then', None),
    (2, 'unary{operand}', _complement_34),
    (3, 'name{NAME}', _name_empty_30),
    (2, 'unary{operand}', _minus_35),
    (2, 'unary{operand}', _plus_37),
    (3, 'inline_statement', _line_print_38),
    (1, 'print_last', _last_item_39),
    (3, 'inline_statement', _print_40),
    (0, 'task_body', _body_11),
    (1, 'seps', _none_41),
    (0, 'members', _none_0),
    (2, 'body', _skip_4),
    (3, 'inline_statement', _for_42),
    (2, 'body', _label_before_9),
    (3, 'inline_statement', _for_shared_43),
    (3, 'ref{name{leading}}', _member_44),
    (3, 'ref{name{NAME}}', _member_44),
    (3, 'select_head', _next_case_45),
    (1, 'slots', _one_omitted_46),
    (3, 'inline_statement', 2),
    (3, 'inline_statement', _assign_48),
    (4, 'name{leading}', 3),
    (4, 'name{leading}', _name_args_50),
    (4, 'name{leading}', _name_axes_51),
    (1, 'type', _type_52),
    (3, 'constant', _constant_53),
    (3, 'constants', _more_54),
    (4, 'inline_statement', _define_55),
    (3, 'closed_dims', _plain_more_56),
    (3, 'closed_dims', _more_54),
    (3, 'open_dims', _more_54),
    (3, 'typed', _variable_57),
    (3, 'valued', _valued_variable_58),
    (3, 'open_dims', _more_values_59),
    (3, 'closed_dims', _more_54),
    (3, 'open_dims', _more_54),
    (1, 'parameter', _parameter_60),
    (1, 'leading', None),
    (1, 'leading', None),
    (2, 'parameters', _none_61),
    (1, 'parameter_list', _one_12),
    (3, 'name{word}', _name_empty_30),
    (3, 'atom', 4),
    (3, 'and{atom}', _and_63),
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
    (2, 'line_then', _skip_4),
    (1, 'closed', _one_12),
    (1, 'line_tail', None),
    (1, 'closed', None),
    (1, 'inline', _one_12),
    (1, 'line_tail', _one_12),
    (4, 'line_if', _line_if_65),
    (3, 'ref{name{word}}', _member_44),
    (3, 'or{atom}', _or_66),
    (3, 'or{atom}', _xor_67),
    (3, 'shift{atom}', 0),
    (3, 'sum{atom}', 0),
    (3, 'sum{atom}', 0),
    (3, 'term{atom}', 0),
    (3, 'term{atom}', _mod_68),
    (3, 'term{atom}', _mod_68),
    (3, 'term{atom}', 0),
    (4, 'inline_statement', _input_69),
    (4, 'inline_statement', _input_69),
    (1, 'formats', _one_12),
    (4, 'inline_statement', _input_70),
    (1, 'end_loop', None),
    (1, 'end_loop', None),
    (4, 'inline_statement', _loop_71),
    (4, 'name{NAME}', 3),
    (4, 'name{NAME}', _name_args_50),
    (4, 'name{NAME}', _name_axes_51),
    (3, 'and{operand}', _and_63),
    (3, 'power{operand}', 0),
    (3, 'bare', _more_54),
    (2, 'rest', _rest_72),
    (2, 'rest', _rest_last_73),
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
    (3, 'or{operand}', _or_66),
    (3, 'or{operand}', _xor_67),
    (3, 'shift{operand}', 0),
    (3, 'sum{operand}', 0),
    (3, 'sum{operand}', 0),
    (3, 'term{operand}', 0),
    (3, 'term{operand}', _mod_68),
    (3, 'term{operand}', _mod_68),
    (3, 'term{operand}', 0),
    (3, 'print_list', _print_item_74),
    (3, 'print_list', _print_item_74),
    (2, 'seps', _skip_4),
    (4, 'inline_statement', _for_75),
    (3, 'body', 1),
    (3, 'body', 1),
    (3, 'body', 1),
    (1, 'test', _test_76),
    (1, 'tests', _one_12),
    (4, 'select', _last_case_77),
    (2, 'slots', _one_78),
    (4, 'inline_statement', _assign_same_79),
    (2, 'slots', _next_omitted_80),
    (2, 'values', _last_81),
    (4, 'inline_statement', _assign_82),
    (3, 'several', _pair_83),
    (3, 'several', _more_54),
    (3, 'exprs', _more_54),
    (4, 'declared', 3),
    (4, 'declared', _name_args_50),
    (2, 'parameter', _parameter_by_reference_84),
    (2, 'parameter', _parameter_by_value_85),
    (3, 'parameters', 4),
    (4, 'name{word}', 3),
    (4, 'name{word}', _name_args_50),
    (4, 'name{word}', _name_axes_51),
    (1, 'end_if', None),
    (1, 'if_tail', _none_41),
    (5, 'statement', _if_do_86),
    (2, 'inline', _skip_4),
    (5, 'inline_statement', _input_87),
    (2, 'end_loop', _skip_4),
    (3, 'rest', _rest_88),
    (5, 'inline_statement', _print_89),
    (3, 'print_last', _last_using_90),
    (5, 'inline_statement', _repeat_91),
    (5, 'select_head', _select_92),
    (5, 'declaration', _startup_93),
    (2, 'task_body', _skip_4),
    (2, 'task_body', _label_before_9),
    (1, 'member_list', _one_12),
    (1, 'end_while', None),
    (1, 'end_while', None),
    (1, 'end_while', None),
    (5, 'inline_statement', _while_94),
    (3, 'case', _case_else_95),
    (3, 'case', _case_96),
    (3, 'slots', 1),
    (3, 'type', _sized_type_97),
    (5, 'constant', _constant_98),
    (5, 'valued', _typed_variable_99),
    (6, 'declaration', _event_100),
    (3, 'parameter', _parameter_101),
    (3, 'parameter', _parameter_102),
    (3, 'parameter_list', _more_54),
    (2, 'else_if', _skip_4),
    (2, 'end_if', _skip_4),
    (6, 'statement', _if_103),
    (2, 'line_else', _skip_4),
    (6, 'line_if', _line_if_else_104),
    (3, 'closed', _more_54),
    (3, 'inline', _more_54),
    (3, 'line_tail', _more_54),
    (6, 'inline_statement', _input_105),
    (6, 'inline_statement', _input_105),
    (3, 'formats', _pair_83),
    (4, 'rest', _rest_using_106),
    (6, 'inline_statement', _print_107),
    (4, 'print_last', _last_open_108),
    (5, 'print_list', _print_using_109),
    (6, 'select', _select_nothing_110),
    (6, 'declaration', _task_111),
    (3, 'task_body', 1),
    (3, 'task_body', 1),
    (3, 'task_body', 1),
    (3, 'task_body', 1),
    (3, 'task_body', 1),
    (6, 'declaration', _user_type_112),
    (3, 'members', _extend_113),
    (3, 'members', _extend_113),
    (2, 'end_while', _skip_4),
    (5, 'shared', _shared_further_114),
    (6, 'ref{name{leading}}', _member_args_115),
    (6, 'ref{name{NAME}}', _member_args_115),
    (3, 'test', _test_is_116),
    (3, 'test', _test_is_116),
    (3, 'test', _test_range_117),
    (3, 'tests', _more_54),
    (7, 'for_head', _for_head_118),
    (4, 'parameter', _parameter_by_reference_119),
    (4, 'parameter', _parameter_by_reference_120),
    (4, 'parameter', _parameter_by_value_121),
    (4, 'parameter', _parameter_by_value_122),
    (7, 'routine', _function_123),
    (6, 'ref{name{word}}', _member_args_115),
    (7, 'inline_statement', _input_124),
    (7, 'inline_statement', _input_124),
    (7, 'inline_statement', _input_125),
    (5, 'rest', _rest_using_126),
    (7, 'routine', _sub_127),
    (4, 'members', _extend_128),
    (4, 'members', _extend_128),
    (3, 'member_list', _more_54),
    (6, 'shared', _shared_129),
    (5, 'parameter', _parameter_130),
    (4, 'if_tail', _third_131),
    (6, 'rest', _rest_using_two_132),
    (6, 'rest', _rest_using_two_132),
    (7, 'print_list', _print_using_two_133),
    (7, 'print_list', _print_using_two_133),
    (9, 'for_head', _for_head_134),
    (6, 'parameter', _parameter_by_reference_135),
    (6, 'parameter', _parameter_by_value_136),
    (9, 'routine', _function_137),
    (5, 'if_tail', _else_if_138),
    (5, 'if_tail', _else_if_138),
    (6, 'closed_if', _line_if_else_104),
    (9, 'inline_statement', _input_139),
    (9, 'inline_statement', _input_139),
    (7, 'rest', _rest_using_two_140),
    (7, 'rest', _rest_using_two_140),
)

ROWS = (
    '1=items 2=start d0',
    '3=AUTO 4=BYREF,BYVAL,NV,STEP,TO,USING,leading 5=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 11=EVENT 12=EXIT 13=FOR 14=FUNCTION 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 28=STARTUP 29=SUB 30=TASK 31=TYPE 32=WHILE 33=_NL 34=axes 35=call 36=declaration,routine 37=for_head 38=inline_statement,select,statement 39=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target d1',
    '',
    'r2=COLON,ELSE,_NL d3',
    '45=LPAR 46=LSQB d4',
    'd5',
    '47=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 48=constant 49=constants',
    '50=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '51=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 52=NV 53=closed_dims 54=declared 55=dims 56=open_dims 57=typed 58=valued',
    'd6',
    '59=NAME d7',
    '60=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d8',
    '61=EVENT,FOR,FUNCTION,LOOP,REPEAT,SELECT,SUB,TASK,WHILE,exit_kind d9',
    '62=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '63=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '64=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word 65=HASH',
    '66=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word 67=HASH',
    '68=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 83=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 89=HASH 90=STRING 91=axes,variable 84=name{word},ref{name{word}} d10',
    '92=COLON,_NL,sep',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 93=COMPLEMENT 9=DOTTED 94=LPAR 95=LSQB 96=MINUS 74=NOT 75=NUMBER 97=PLUS 77=STRING 98=and{operand},bit_and_not{operand},bit_or_not{operand},compare_not{operand},negated,not{operand} 99=axes,operand,power{operand},unary{operand},variable 100=bare 101=bit_and{operand} 102=bit_or{operand} 103=compare{operand} 84=name{word},ref{name{word}} 104=or{operand} 105=shift{operand} 106=sum{operand} 107=term{operand} d11',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 108=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '109=HASH 110=print_list d12',
    '111=COLON,_NL,sep',
    'd13',
    '112=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d14',
    '113=CASE',
    '114=COLON,_NL,sep d15',
    '115=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '116=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d16',
    '117=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d17',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 118=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd18',
    'r19=EQUAL d20',
    'd21',
    '119=COLON 120=_NL',
    '121=body 122=shared d22',
    '123=COLON 124=_NL',
    '125=_NL',
    'r23=DOT,EQUAL d24',
    '126=DOT d25',
    '127=DOT d26',
    '128=body d22',
    '129=EQUAL',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 130=RPAR 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 131=expr 84=name{word},ref{name{word}} 85=or{atom} 132=several 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 133=expr 134=exprs 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '135=AS 136=EQUAL',
    'd27',
    '137=COMMA d28',
    '138=EQUAL',
    '139=LPAR d29',
    '51=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 53=closed_dims 54=declared 140=dims 56=open_dims 57=typed 58=valued d30',
    '141=COMMA d31',
    '142=AS 143=EQUAL d32',
    'd33',
    '144=COMMA d34',
    'd35',
    'd36',
    'd37',
    '145=COLON,_NL,sep',
    'd38',
    '146=EQUAL',
    '147=LPAR 148=parameters d39',
    'd40',
    '149=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word',
    'd41',
    '150=AUTO,BYREF,BYVAL,END,EVENT,EXIT,INPUT,LOOP,NAME,NEXT,NV,PAUSE,REPEAT,RETURN,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,label,leading,word',
    'd42',
    '151=LPAR 152=LSQB d43',
    'd44',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 153=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 154=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 155=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 156=bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 84=name{word},ref{name{word}} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd45',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 157=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    'd46',
    '158=AND d47',
    '159=CIRCUMFLEX d48',
    '160=AMPERSAND d49',
    '161=VBAR d50',
    '162=COMPARE 163=EQUAL d51',
    '164=DO 165=THEN 166=line_then',
    '167=DOT d52',
    '168=OR 169=XOR d53',
    '170=SHIFT d54',
    '171=MINUS 172=PLUS d55',
    '173=DIVIDE 174=MOD 175=PERCENT 176=STAR d56',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 177=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '178=COMMA 179=SEMICOLON',
    '180=USING d57',
    '181=body d22',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 182=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 183=RPAR 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 184=expr 84=name{word},ref{name{word}} 85=or{atom} 185=several 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 133=expr 186=exprs 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 187=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 188=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    '189=AND d58',
    '190=CIRCUMFLEX d59',
    '191=COMMA 192=SEMICOLON 193=USING 194=rest d60',
    '195=AMPERSAND d61',
    '196=VBAR d62',
    '197=COMPARE 198=EQUAL d63',
    '199=OR 200=XOR d64',
    '201=SHIFT d65',
    '202=MINUS 203=PLUS d66',
    '204=DIVIDE 205=MOD 206=PERCENT 207=STAR d67',
    'd68',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 208=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 209=expr 84=name{word},ref{name{word}} 85=or{atom} 210=print_last 86=shift{atom} 87=sum{atom} 88=term{atom} d69',
    '211=body d22',
    'd70',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 212=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '213=body d22',
    '147=LPAR 214=parameters d39',
    '215=COLON,_NL,sep',
    '216=COLON,_NL,sep 217=seps',
    '218=COLON,_NL,sep',
    'd71',
    'd72',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 219=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 220=NEXT 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 221=_NL 34=axes 35=call 222=for_head 223=inline_statement,select,statement 224=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '225=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd73',
    'd74',
    'd75',
    '226=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '227=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 228=CASE 219=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 229=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 221=_NL 34=axes 35=call 230=case 37=for_head 223=inline_statement,select,statement 224=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 231=COMMA 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 232=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 233=slots 87=sum{atom} 88=term{atom} 234=values',
    'd76',
    '235=COMMA 236=RPAR',
    '237=COMMA 238=RPAR',
    'd77',
    '239=COMMA 240=RSQB',
    '241=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 242=type',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 243=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '47=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 244=constant',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 245=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 246=expr 84=name{word},ref{name{word}} 85=or{atom} 247=several 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd78',
    '51=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 248=declared 249=typed 250=valued',
    '241=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 251=type',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 252=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '253=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 254=bit_and{atom} 255=bit_or{atom} 256=declared 84=name{word},ref{name{word}} 86=shift{atom} 87=sum{atom} 88=term{atom} 257=typed 258=valued',
    '259=body d22',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 260=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '261=AUTO,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 262=BYREF 263=BYVAL 264=RPAR 265=parameter 266=parameter_list',
    '267=AS 268=COLON,_NL,sep',
    'd79',
    'd80',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 269=RPAR 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 270=expr 84=name{word},ref{name{word}} 85=or{atom} 271=several 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 133=expr 272=exprs 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd81',
    '273=RPAR',
    'd82',
    'd83',
    'd84',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 274=bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 84=name{word},ref{name{word}} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 275=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 276=negated 277=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 278=bit_and_not{atom} 279=bit_and{atom} 84=name{word},ref{name{word}} 280=negated 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 281=bit_and_not{atom},bit_or_not{atom} 80=bit_and{atom} 282=bit_or{atom} 84=name{word},ref{name{word}} 283=negated 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 284=bit_and_not{atom},bit_or_not{atom} 80=bit_and{atom} 285=bit_or{atom} 84=name{word},ref{name{word}} 286=negated 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '287=body d22',
    '288=_NL d85',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 289=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 290=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 291=closed 292=closed_if 37=for_head 293=inline 294=inline_statement,select 295=line_if 296=line_tail 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '297=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 298=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 84=name{word},ref{name{word}} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 299=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 84=name{word},ref{name{word}} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 300=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 301=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 302=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 303=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 304=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 305=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 306=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}}',
    '307=COMMA',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 308=axes,variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 309=axes,variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 310=expr 311=formats 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 219=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 312=END 313=ENDL 314=ENDLOOP 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 221=_NL 34=axes 35=call 315=end_loop 37=for_head 223=inline_statement,select,statement 224=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    'd86',
    'd87',
    '235=COMMA 316=RPAR',
    '237=COMMA 317=RPAR',
    '239=COMMA 318=RSQB',
    'd88',
    'd89',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 319=bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 84=name{word},ref{name{word}} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 320=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 321=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '322=print_list d12',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 323=expr 324=formats 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd90',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 325=negated 326=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 327=bit_and_not{atom} 328=bit_and{atom} 84=name{word},ref{name{word}} 329=negated 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 330=bit_and_not{atom},bit_or_not{atom} 80=bit_and{atom} 331=bit_or{atom} 84=name{word},ref{name{word}} 332=negated 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 333=bit_and_not{atom},bit_or_not{atom} 80=bit_and{atom} 334=bit_or{atom} 84=name{word},ref{name{word}} 335=negated 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 336=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 84=name{word},ref{name{word}} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 337=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 84=name{word},ref{name{word}} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 338=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 339=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 340=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 341=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 342=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 343=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 344=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}}',
    '345=COMMA',
    '346=COMMA 347=SEMICOLON 348=USING d91',
    'd92',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 219=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 349=UNTIL 32=WHILE 221=_NL 34=axes 35=call 37=for_head 223=inline_statement,select,statement 224=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '216=COLON,_NL,sep 350=seps',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 219=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 351=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 221=_NL 34=axes 35=call 37=for_head 223=inline_statement,select,statement 224=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '352=COLON,_NL,sep',
    '353=task_body d93',
    'd94',
    '354=COLON,_NL,sep 355=members d95',
    '356=body d22',
    'd96',
    '357=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d97',
    'd98',
    '358=body 359=shared d22',
    '360=COLON 361=_NL',
    '362=_NL',
    'd99',
    '363=LPAR d100',
    '364=LPAR d101',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 365=ELSE 366=IS 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 367=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom} 368=test 369=tests',
    '59=NAME 370=SELECT d7',
    'd102',
    'd103',
    '371=COMMA 372=SEMICOLON d104',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 373=COMMA 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 374=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '375=SEMICOLON d105',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 376=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd106',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 377=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd107',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 378=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd108',
    '379=STAR d109',
    '380=EQUAL',
    'd110',
    'd111',
    'd112',
    '235=COMMA 381=RPAR',
    '237=COMMA 382=RPAR',
    '142=AS 143=EQUAL d113',
    'd114',
    'd115',
    '383=EQUAL d116',
    'd117',
    'r29=AS,EQUAL 384=LPAR 152=LSQB d43',
    '385=AMPERSAND d49',
    '386=VBAR d118',
    '142=AS 143=EQUAL',
    'd119',
    'd120',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 219=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 387=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 221=_NL 34=axes 35=call 37=for_head 223=inline_statement,select,statement 224=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '388=TO',
    '389=AS 390=LPAR d121',
    '391=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d122',
    '392=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d123',
    'd124',
    'd125',
    '393=COMMA 394=RPAR',
    '241=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 395=type',
    '396=body d22',
    'd126',
    '235=COMMA 397=RPAR',
    '237=COMMA 398=RPAR',
    '239=COMMA 399=RSQB',
    'd127',
    'd128',
    'd129',
    'd130',
    '170=SHIFT d131',
    'd132',
    '160=AMPERSAND d133',
    'd134',
    'd135',
    '161=VBAR d136',
    'd137',
    'd138',
    '161=VBAR d139',
    'd140',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 219=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 400=ELSE 401=ELSEIF,else_if 402=END 403=ENDIF 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 221=_NL 34=axes 35=call 404=end_if 37=for_head 405=if_tail 223=inline_statement,select,statement 224=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '406=body d22',
    'd141',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 407=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '408=ELSE,line_else',
    'd142',
    '409=COLON r143=_NL d144',
    'd145',
    'd146',
    'd147',
    '410=LPAR d148',
    '158=AND d149',
    '158=AND d150',
    '171=MINUS 172=PLUS d151',
    '173=DIVIDE 174=MOD 175=PERCENT 176=STAR d152',
    '173=DIVIDE 174=MOD 175=PERCENT 176=STAR d153',
    '159=CIRCUMFLEX d154',
    '159=CIRCUMFLEX d155',
    '159=CIRCUMFLEX d156',
    '159=CIRCUMFLEX d157',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 411=STRING 412=axes,variable 84=name{word},ref{name{word}}',
    '413=USING d158',
    '414=USING d159',
    '415=COMMA d160',
    'd161',
    '416=LOOP 59=NAME d7',
    'd162',
    'd163',
    'd164',
    'd165',
    'd166',
    'd167',
    'd168',
    'd169',
    'd170',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 209=expr 84=name{word},ref{name{word}} 85=or{atom} 417=print_last 86=shift{atom} 87=sum{atom} 88=term{atom} d171',
    '418=COMMA 419=SEMICOLON d160',
    'd172',
    'd173',
    '170=SHIFT d174',
    'd175',
    '160=AMPERSAND d176',
    'd177',
    'd178',
    '161=VBAR d179',
    'd180',
    'd181',
    '161=VBAR d182',
    'd183',
    '158=AND d184',
    '158=AND d185',
    '171=MINUS 172=PLUS d186',
    '173=DIVIDE 174=MOD 175=PERCENT 176=STAR d187',
    '173=DIVIDE 174=MOD 175=PERCENT 176=STAR d188',
    '159=CIRCUMFLEX d189',
    '159=CIRCUMFLEX d190',
    '159=CIRCUMFLEX d191',
    '159=CIRCUMFLEX d192',
    '420=print_list d12',
    'd193',
    'd194',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 421=expr 422=formats 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 423=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '228=CASE 354=COLON,_NL,sep 424=END 425=case',
    '59=NAME 426=STARTUP d7',
    '427=body d22',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 428=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 429=END 12=EXIT 13=FOR 14=FUNCTION 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 29=SUB 32=WHILE 430=_NL 34=axes 35=call 37=for_head 431=inline_statement,select,statement 432=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 433=routine 43=select_head 44=target',
    'd195',
    '51=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 434=DIM 435=END 436=declared 437=member_list 438=typed',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 219=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 439=END 440=ENDW 441=ENDWHILE 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 442=WEND 32=WHILE 221=_NL 34=axes 35=call 443=end_while 37=for_head 223=inline_statement,select,statement 224=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    'd196',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 219=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 444=NEXT 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 221=_NL 34=axes 35=call 222=for_head 223=inline_statement,select,statement 224=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '445=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd197',
    'd198',
    'd199',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 133=expr 446=exprs 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 133=expr 447=exprs 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '448=COLON,_NL,sep',
    '449=COMPARE 450=EQUAL',
    '451=TO d200',
    'd201',
    '452=COLON,_NL,sep 453=COMMA',
    'd202',
    'd203',
    'd204',
    'd205',
    '454=COMMA d206',
    'd207',
    'd208',
    'd209',
    'd210',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 455=atom,axes,operand,unary{atom},variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 456=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd211',
    'd212',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 457=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 269=RPAR 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 458=expr 84=name{word},ref{name{word}} 85=or{atom} 459=several 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 84=name{word},ref{name{word}} 277=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 75=NUMBER 76=PLUS 77=STRING 79=atom,axes,operand,power{atom},unary{atom},variable 460=bit_and{atom} 84=name{word},ref{name{word}} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '461=EVENT 59=NAME d7',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 462=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '241=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 463=type',
    '464=RPAR',
    '465=AS 466=LPAR d213',
    '467=AS 468=LPAR d214',
    '261=AUTO,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 262=BYREF 263=BYVAL 469=parameter',
    'd215',
    '470=COLON,_NL,sep',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 219=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 471=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 221=_NL 34=axes 35=call 37=for_head 223=inline_statement,select,statement 224=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    'd216',
    'd217',
    'd218',
    '472=COLON,_NL,sep 473=IF',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 474=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '475=IF 59=NAME d7',
    'd219',
    'd220',
    'd221',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 219=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 400=ELSE 401=ELSEIF,else_if 402=END 403=ENDIF 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 221=_NL 34=axes 35=call 404=end_if 37=for_head 476=if_tail 223=inline_statement,select,statement 224=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '477=THEN,line_then',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 478=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 479=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 37=for_head 480=inline 294=inline_statement,select 295=line_if 481=line_tail 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 290=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 482=closed_if 37=for_head 483=inline_statement,select 484=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target d222',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 133=expr 485=exprs 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '486=COMMA 487=SEMICOLON',
    '488=USING d223',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 310=expr 489=formats 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 310=expr 490=formats 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 491=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd224',
    'd225',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 492=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '493=print_list d12',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 209=expr 84=name{word},ref{name{word}} 85=or{atom} 494=print_last 86=shift{atom} 87=sum{atom} 88=term{atom} d226',
    '495=COMMA 496=SEMICOLON d160',
    'd227',
    'd228',
    '497=SELECT',
    'd229',
    'd230',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 219=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 498=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 221=_NL 34=axes 35=call 37=for_head 223=inline_statement,select,statement 224=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    'd231',
    '59=NAME 499=TASK d7',
    'd232',
    '500=COLON 501=_NL',
    '502=_NL',
    '503=COLON 504=_NL',
    '51=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 436=declared 505=member_list 438=typed',
    '506=TYPE',
    '507=AS',
    '508=COLON 509=COMMA 510=_NL',
    'd233',
    '59=NAME 511=WHILE d7',
    'd234',
    'd235',
    'd236',
    'd237',
    '512=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d97',
    '513=COMMA d99',
    '239=COMMA 514=RPAR',
    '239=COMMA 515=RPAR',
    'd238',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 516=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 517=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 518=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd239',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 366=IS 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 367=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom} 519=test',
    'd240',
    'd241',
    'd242',
    'd243',
    '235=COMMA 520=RPAR',
    '237=COMMA 521=RPAR',
    '385=AMPERSAND d133',
    'd244',
    '522=COLON,_NL,sep 523=STEP',
    'd245',
    '524=AS d246',
    '241=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 525=type',
    '526=RPAR',
    '241=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 527=type',
    '528=RPAR',
    'd247',
    '529=body d22',
    '530=FUNCTION 59=NAME d7',
    '531=body d22',
    'd248',
    '532=DO 533=THEN',
    'd249',
    'd250',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 289=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 290=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 534=closed 292=closed_if 37=for_head 293=inline 294=inline_statement,select 295=line_if 296=line_tail 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    'd251',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 535=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '536=COLON d143',
    'd252',
    'd253',
    'd254',
    'd255',
    '239=COMMA 537=RPAR',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 538=axes,variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 9=DOTTED 539=axes,variable 84=name{word},ref{name{word}}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 310=expr 540=formats 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    'd256',
    'd257',
    'd258',
    '541=COMMA 542=SEMICOLON d258',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 209=expr 84=name{word},ref{name{word}} 85=or{atom} 543=print_last 86=shift{atom} 87=sum{atom} 88=term{atom} d259',
    'd260',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 544=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom} d261',
    'd262',
    'd263',
    '59=NAME 545=SUB d7',
    'd264',
    'd265',
    'd266',
    'd267',
    'd268',
    'd269',
    '546=COLON 509=COMMA 547=_NL',
    'd270',
    '241=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 548=type',
    'd271',
    '51=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 436=declared 549=typed',
    'd272',
    'd273',
    '550=COMMA d196',
    'd274',
    'd275',
    'd276',
    'd277',
    'd278',
    'd279',
    'd280',
    'r211=AS,EQUAL d216',
    'r212=AS,EQUAL d217',
    'd281',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 551=expr 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '241=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 552=type',
    'd282',
    '553=AS d283',
    'd284',
    '554=AS d285',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 219=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 555=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 221=_NL 34=axes 35=call 37=for_head 223=inline_statement,select,statement 224=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    'd286',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 219=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 402=END 403=ENDIF 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 221=_NL 34=axes 35=call 556=end_if 37=for_head 223=inline_statement,select,statement 224=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '557=body d22',
    '558=body d22',
    '559=ELSE,line_else',
    '166=THEN,line_then',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 479=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 37=for_head 483=inline_statement,select 484=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target d222',
    'd287',
    '560=USING d288',
    '561=USING d289',
    'd290',
    '562=print_list d12',
    '563=print_list d12',
    'd291',
    '564=COMMA 565=SEMICOLON d258',
    'd292',
    'd293',
    'd294',
    'd116',
    'd295',
    'd296',
    '566=COLON,_NL,sep',
    'd297',
    '241=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 567=type',
    '241=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 568=type',
    '569=FUNCTION 59=NAME d7',
    'd298',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 219=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 400=ELSE 401=ELSEIF,else_if 402=END 403=ENDIF 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 221=_NL 34=axes 35=call 404=end_if 37=for_head 570=if_tail 223=inline_statement,select,statement 224=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 219=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 400=ELSE 401=ELSEIF,else_if 402=END 403=ENDIF 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 18=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 221=_NL 34=axes 35=call 404=end_if 37=for_head 571=if_tail 223=inline_statement,select,statement 224=line_if 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '3=AUTO 4=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 478=COLON 6=CONST 7=DEFINE 8=DIM 9=DOTTED 10=END 12=EXIT 13=FOR 15=GOSUB 16=GOTO 17=HASH 290=IF 19=INPUT 20=LOOP 21=NAME 22=PAUSE 23=PRINT,QMARK,print 24=REPEAT 25=RETURN 26=RUN 27=SELECT 32=WHILE 34=axes 35=call 572=closed 292=closed_if 37=for_head 293=inline 294=inline_statement,select 295=line_if 481=line_tail 40=name{NAME} 41=name{leading},ref{name{leading}} 42=ref{name{NAME}} 43=select_head 44=target',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 310=expr 573=formats 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 310=expr 574=formats 84=name{word},ref{name{word}} 85=or{atom} 86=shift{atom} 87=sum{atom} 88=term{atom}',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 209=expr 84=name{word},ref{name{word}} 85=or{atom} 575=print_last 86=shift{atom} 87=sum{atom} 88=term{atom} d299',
    '69=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 70=CHARACTER 71=COMPLEMENT 9=DOTTED 72=LPAR 73=MINUS 74=NOT 75=NUMBER 76=PLUS 77=STRING 78=and{atom},bit_and_not{atom},bit_or_not{atom},compare_not{atom},negated,not{atom} 79=atom,axes,operand,power{atom},unary{atom},variable 80=bit_and{atom} 81=bit_or{atom} 82=compare{atom} 209=expr 84=name{word},ref{name{word}} 85=or{atom} 576=print_last 86=shift{atom} 87=sum{atom} 88=term{atom} d300',
    'd301',
    'd302',
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
