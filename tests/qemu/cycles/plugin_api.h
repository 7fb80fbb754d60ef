#pragma once
#include <stddef.h>
#include <stdint.h>

/// What this project uses of QEMU's interface for TCG plugins, version 1 (documentation: "QEMU TCG Plugins"). QEMU 7.2
/// is packed without a header for it, so the few functions are declared here; QEMU resolves them when it loads the
/// plugin.
extern "C" {

using qemu_plugin_id_t = uint64_t;

/// What QEMU is; the plugin asks nothing of it.
struct qemu_info_t;
/// A translation block, and one of its instructions: valid inside the translation callback only.
struct qemu_plugin_tb;
struct qemu_plugin_insn;

/// Whether a callback looks at guest registers. Version 1 has nothing to read them with.
enum qemu_plugin_cb_flags { QEMU_PLUGIN_CB_NO_REGS, QEMU_PLUGIN_CB_R_REGS, QEMU_PLUGIN_CB_RW_REGS };

using qemu_plugin_vcpu_tb_trans_cb_t = void (*)(qemu_plugin_id_t, qemu_plugin_tb*);
using qemu_plugin_vcpu_udata_cb_t = void (*)(unsigned vcpu, void* data);
using qemu_plugin_udata_cb_t = void (*)(qemu_plugin_id_t, void* data);

void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t id, qemu_plugin_vcpu_tb_trans_cb_t callback);
void qemu_plugin_register_vcpu_tb_exec_cb(qemu_plugin_tb* block, qemu_plugin_vcpu_udata_cb_t callback,
                                          qemu_plugin_cb_flags flags, void* data);
void qemu_plugin_register_vcpu_insn_exec_cb(qemu_plugin_insn* instruction, qemu_plugin_vcpu_udata_cb_t callback,
                                            qemu_plugin_cb_flags flags, void* data);
void qemu_plugin_register_atexit_cb(qemu_plugin_id_t id, qemu_plugin_udata_cb_t callback, void* data);

size_t qemu_plugin_tb_n_insns(const qemu_plugin_tb* block);
qemu_plugin_insn* qemu_plugin_tb_get_insn(const qemu_plugin_tb* block, size_t index);
uint64_t qemu_plugin_tb_vaddr(const qemu_plugin_tb* block);
const void* qemu_plugin_insn_data(const qemu_plugin_insn* instruction);
size_t qemu_plugin_insn_size(const qemu_plugin_insn* instruction);

/// Defined by the plugin: the version it was written for, and its start. Non-zero refuses to run.
[[gnu::visibility("default")]] extern int qemu_plugin_version;
[[gnu::visibility("default")]] int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t* info, int count,
                                                       char** arguments);

}  // extern "C"
