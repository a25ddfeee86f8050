// A session of @vscode/debugadapter-testsupport's DebugClient with `motionlang dap`; prints what it saw as JSON.
//
//     node debug_client.js PYTHON PROGRAM
'use strict';
const { DebugClient } = require('@vscode/debugadapter-testsupport');

const [python, program] = process.argv.slice(2);
const client = new DebugClient('node', '', 'motionlang');

async function top(stop) {
  const { body } = await client.stackTraceRequest({ threadId: stop.body.threadId });
  return body.stackFrames[0];
}

async function move(request) {
  const stopped = client.waitForEvent('stopped');
  await request;
  const stop = await stopped;
  return [stop.body.reason, (await top(stop)).line];
}

async function main() {
  const { spawn } = require('child_process');
  const adapter = spawn(python, ['-m', 'motionlang', 'dap'], { stdio: ['pipe', 'pipe', 'inherit'] });
  client.connect(adapter.stdout, adapter.stdin);
  const seen = {};
  const started = client.waitForEvent('initialized');
  seen.capabilities = (await client.initializeRequest()).body.supportsStepBack;
  await client.launchRequest({ program });
  await started;
  const source = { path: program };
  const points = await client.setBreakpointsRequest({ source, breakpoints: [{ line: 4, condition: 'n = 2' }] });
  seen.verified = points.body.breakpoints.map((each) => each.verified);
  await client.setFunctionBreakpointsRequest({ breakpoints: [] });
  await client.setExceptionBreakpointsRequest({ filters: ['error', 'limit'] });
  seen.moves = [await move(client.configurationDoneRequest())];
  const threads = (await client.threadsRequest()).body.threads;
  seen.threads = threads.map((each) => each.name);
  const threadId = threads[0].id;
  const frame = await top({ body: { threadId } });
  const scopes = (await client.scopesRequest({ frameId: frame.id })).body.scopes;
  seen.scopes = scopes.map((each) => each.name);
  const { variablesReference } = scopes[0];
  const local = async () => (await client.variablesRequest({ variablesReference })).body.variables;
  seen.local = (await local()).map((each) => [each.name, each.value]);
  seen.set = (await client.setVariableRequest({ variablesReference, name: 'n', value: '20' })).body.value;
  seen.evaluated = (await client.evaluateRequest({ expression: 'n + total' })).body.result;
  const data = (await client.dataBreakpointInfoRequest({ name: 'total' })).body.dataId;
  await client.setDataBreakpointsRequest({ breakpoints: [] });
  seen.data = data;
  seen.moves.push(await move(client.nextRequest({ threadId })));
  seen.moves.push(await move(client.stepOutRequest({ threadId })));
  seen.moves.push(await move(client.stepInRequest({ threadId })));
  seen.moves.push(await move(client.stepBackRequest({ threadId })));
  seen.moves.push(await move(client.reverseContinueRequest({ threadId })));
  seen.moves.push(await move(client.restartRequest({})));
  seen.info = (await client.exceptionInfoRequest({ threadId })).body.breakMode;
  await client.pauseRequest({ threadId });
  const over = client.waitForEvent('terminated');
  await client.setBreakpointsRequest({ source, breakpoints: [] });
  await client.continueRequest({ threadId });
  await over;
  await client.disconnectRequest({});
  seen.status = await new Promise((resolve) => adapter.on('exit', resolve));
  console.log(JSON.stringify(seen));
}

main().catch((error) => { console.error(error); process.exit(1); });
